"""What the engine's messages say to who uses the window.

By code, or ``code:case`` where one code has several sentences.  Names in braces are places for the
values that the engine sends with a message; ``{canvas}`` is the place for the words that lead to
*Correct Sheet*, which are others where the sentence is said there.  The sentences name what there
is in the window, not the command line's options, and no pixels.
"""

from freecad.gaussiancad.engine.sentences import checking, comparing, doubts, refusals

SENTENCES = {
    **doubts.REASONS,
    **doubts.ASSUMPTIONS,
    **doubts.WARNINGS,
    **refusals.FILES,
    **refusals.VIEWS,
    **refusals.LIMITS,
    **comparing.WARNINGS,
    **comparing.REFUSALS,
    **checking.REASONS,
}

ALTERNATIVES = doubts.ALTERNATIVES
