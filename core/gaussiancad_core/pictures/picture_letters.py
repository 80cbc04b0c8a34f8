"""Letters in pictures."""

import numpy as np
import numpy.typing as npt

Image = npt.NDArray[np.uint8]


def text_image(text: str, letters: int) -> Image:
    """(h, w) dark letters on white, in a size of ``letters`` px."""
    from PIL import Image as PillowImage
    from PIL import ImageDraw, ImageFont

    font = ImageFont.load_default(letters)
    left, top, right, bottom = font.getbbox(text)
    image = PillowImage.new("L", (int(right - left) + 2, int(bottom - top) + 2), 255)
    ImageDraw.Draw(image).text((1 - left, 1 - top), text, fill=60, font=font)
    return np.asarray(image)


def put_text(picture: Image, text: Image, x: int, y: int) -> None:
    """Lay letters over an (h, w, 3) picture, their upper left corner at a pixel; clipped."""
    x0, y0 = max(x, 0), max(y, 0)
    x1 = min(x + text.shape[1], picture.shape[1])
    y1 = min(y + text.shape[0], picture.shape[0])
    if x0 >= x1 or y0 >= y1:
        return
    part = text[y0 - y : y1 - y, x0 - x : x1 - x, None]
    picture[y0:y1, x0:x1] = np.minimum(picture[y0:y1, x0:x1], part)
