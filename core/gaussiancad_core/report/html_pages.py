"""HTML pages from templates: text is escaped, and a value that is missing is an error."""

from functools import cache
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined


@cache
def _templates(package: str) -> Environment:
    """The templates in the folder ``assets`` of a package."""
    return Environment(
        loader=PackageLoader(package, "assets"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def html_page(package: str, template: str, **values: Any) -> bytes:  # noqa: ANN401
    """A page, UTF-8.

    Args:
        package: that has the template in its folder ``assets``.
        template: name of the file.
        values: of the template's variables.
    """
    text = _templates(package).get_template(template).render(**values)
    # Names of files may hold bytes that are no text.
    return text.encode("utf-8", "backslashreplace")
