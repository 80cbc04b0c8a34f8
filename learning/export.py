"""A trained labels network as the file that the engine loads."""

import hashlib
import io
import warnings
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import torch

from learning.unet import LabelsNetwork

_OPSET = 17
_SIDE = 64
"""px of the picture with which the graph is recorded; it takes any size."""

_LEAST_HALVED = 64
"""Numbers of a tensor from which it is stored in half precision."""


def write_network(
    network: LabelsNetwork, path: Path, metadata: Mapping[str, str] | None = None
) -> str:
    """Write the graph with its weights in half precision, and its digest beside it.

    Args:
        network: trained; it is put into its mode of use.
        path: of the ONNX file; ``path`` + ``.sha256`` has the digest.
        metadata: what the file tells of itself beside the graph.

    Returns:
        The SHA-256 of the file, hexadecimal.
    """
    data = _halved(_recorded(network), metadata or {})
    digest = hashlib.sha256(data).hexdigest()
    path.write_bytes(data)
    path.with_name(path.name + ".sha256").write_text(f"{digest}\n", encoding="ascii")
    return digest


def _recorded(network: LabelsNetwork) -> bytes:
    buffer = io.BytesIO()
    sides = {2: "height", 3: "width"}
    with warnings.catch_warnings():
        # The recorder is the old one of two: the new one asks for another package.
        warnings.simplefilter("ignore")
        torch.onnx.export(
            network.eval().cpu().float(),
            (torch.zeros(1, 1, _SIDE, _SIDE),),
            buffer,  # type: ignore[arg-type] # the old recorder writes into what is open, too
            input_names=["ink"],
            output_names=["logits"],
            dynamic_axes={"ink": sides, "logits": sides},
            dynamo=False,
            opset_version=_OPSET,
        )
    return buffer.getvalue()


def _halved(data: bytes, metadata: Mapping[str, str]) -> bytes:
    """The same with its weights in half precision, each made whole again when it is loaded."""
    import onnx

    model = onnx.load_model_from_string(data)
    casts = []
    for item in model.graph.initializer:
        values = onnx.numpy_helper.to_array(item)
        if values.dtype == np.float32 and values.size >= _LEAST_HALVED:
            name = item.name
            item.CopyFrom(onnx.numpy_helper.from_array(values.astype(np.float16), f"{name}_half"))
            casts.append(
                onnx.helper.make_node("Cast", [f"{name}_half"], [name], to=onnx.TensorProto.FLOAT)
            )
    for node in reversed(casts):
        model.graph.node.insert(0, node)
    onnx.helper.set_model_props(model, dict(metadata))
    onnx.checker.check_model(model)
    return model.SerializeToString()
