"""From labelled cells to a valid B-Rep, drawn again and checked against the sheet."""
