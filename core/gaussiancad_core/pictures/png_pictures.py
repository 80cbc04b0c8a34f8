"""Pictures as PNG files."""

import numpy as np
import numpy.typing as npt


def png_bytes(image: npt.NDArray[np.uint8]) -> bytes:
    """The (h, w, 3) RGB or (h, w) grey image as PNG."""
    import cv2

    ordered = image if image.ndim == 2 else image[..., ::-1]
    _, content = cv2.imencode(".png", ordered)
    return content.tobytes()
