"""Two readings of the same views: first and third angle.

Under the other one each view beside the front is its opposite, and the part is mirrored.  Which of
them is right is told by solids (:mod:`gaussiancad_core.run.exact_stage`), or sketches
(:mod:`gaussiancad_core.sketch.projection_by_sketch`).
"""

from dataclasses import replace

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Role
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import ReadView, RegisteredSheet, register_views


def both_readings(
    drawn: tuple[ReadView, ...], options: ReadingOptions
) -> tuple[RegisteredSheet, RegisteredSheet | None]:
    """Views on shared axes, as they are named and as the other projection names them.

    Args:
        drawn: views with the roles that they have under the assumed projection.
        options: of the registration.

    Returns:
        The two; None for the other one where the views contradict each other then.

    Raises:
        NoModelError: the views contradict each other as they are named.
    """
    registered = register_views(drawn, options)
    mirrored = tuple(replace(view, role=opposite(view.role)) for view in drawn)
    try:
        return registered, register_views(mirrored, options)
    except NoModelError:
        return registered, None


def opposite(role: Role) -> Role:
    """The role of a view beside the front under the other projection."""
    return _OPPOSITES.get(role, role)


_OPPOSITES = {
    Role.TOP: Role.BOTTOM,
    Role.BOTTOM: Role.TOP,
    Role.LEFT: Role.RIGHT,
    Role.RIGHT: Role.LEFT,
}
