"""How long a pixel of the sheet is on the part: from its dimensions, its scale note, its paper."""
