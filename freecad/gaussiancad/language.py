"""Texts for people: FreeCAD's translator, or the English text where FreeCAD is not around."""

try:
    from FreeCAD import Qt as _freecad_qt

    translate = _freecad_qt.translate
    QT_TRANSLATE_NOOP = _freecad_qt.QT_TRANSLATE_NOOP
except ImportError:

    def translate(context: str, text: str) -> str:
        """The text in the language of a translator that is installed, English without one."""
        try:
            from PySide6.QtCore import QCoreApplication
        except ImportError:
            return text
        return QCoreApplication.translate(context, text)

    def QT_TRANSLATE_NOOP(context: str, text: str) -> str:  # the name that lupdate looks for
        """Mark the text for translation, and return it."""
        return text


__all__ = ["QT_TRANSLATE_NOOP", "translate"]
