"""The pages of a file: what is told of them where one has no views, and what is taken instead."""

from dataclasses import replace

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.messages import Message, args_of, boxes_of, filled
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_protocol.codes import Code


def naming_pages(error: NoModelError, image: SheetImage) -> NoModelError:
    """Why a page has no views that belong together, with how many pages its file has; the same
    error where there is one alone."""
    if image.pages < 2:
        return error
    hint = f"the file has {image.pages} pages, choose another one with --page"
    values = {**args_of(error.message), "pages": image.pages}
    return NoModelError(
        error.code, filled(f"{error.message}; {hint}", values, boxes_of(error.message))
    )


def page_instead(job: Job, image: SheetImage) -> Job | None:
    """The same for the page that brings the views of a first page together; None where no page, or
    several, do, or where the user says something of what is on the first."""
    says = job.given is not None or job.corrections is not None or bool(job.reading.views)
    if job.page != 1 or says or image.brought_together is None:
        return None
    return replace(job, page=image.brought_together)


def tell_page(notes: RunNotes, page: int, image: SheetImage) -> None:
    """Say that another page than the first was taken."""
    notes.warn(
        Code.OTHER_PAGE_TAKEN,
        Message(
            "page 1 of {pages} shows no views that belong together: page {page} was taken, the "
            "layout that brings them together; pass --page if another one is meant",
            pages=image.pages,
            page=page,
        ),
    )
