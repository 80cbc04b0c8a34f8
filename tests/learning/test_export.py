"""A network as a file says what it says in PyTorch, on every run the same."""

import hashlib
from importlib.resources import files
from pathlib import Path

import numpy as np
import onnx
import onnxruntime
import pytest
import torch

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.export import write_network
from learning.unet import LabelsNetwork

pytestmark = pytest.mark.slow

OUTPUTS = len(InkClass) + 2


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> tuple[LabelsNetwork, Path, str]:
    """A network of chance with its file and digest."""
    torch.set_num_threads(1)
    torch.manual_seed(2)
    network = LabelsNetwork()
    with torch.no_grad():
        # Statistics of batches that are not those it begins with.
        network.train()
        for _ in range(3):
            network(torch.rand(2, 1, 64, 64))
    path = tmp_path_factory.mktemp("network") / "labels.onnx"
    return network, path, write_network(network, path, {"temperature": "0.8"})


def session(path: Path) -> onnxruntime.InferenceSession:
    """On one thread."""
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    return onnxruntime.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])


@pytest.mark.parametrize("sides", [(64, 64), (96, 160)])
def test_the_file_says_what_the_network_says_and_the_same_twice(
    written: tuple[LabelsNetwork, Path, str], sides: tuple[int, int]
) -> None:
    network, path, _ = written
    ink = np.random.default_rng(1).random((1, 1, *sides), dtype=np.float32)
    with torch.no_grad():
        wanted = network(torch.from_numpy(ink)).numpy()
    (one,) = session(path).run(None, {"ink": ink})
    (other,) = session(path).run(None, {"ink": ink})
    assert one.shape == (1, OUTPUTS, *sides)
    assert np.abs(one - wanted).max() < 2e-2
    assert np.array_equal(one, other)


def test_the_digest_lies_beside_the_file(written: tuple[LabelsNetwork, Path, str]) -> None:
    _, path, digest = written
    neighbour = path.with_name("labels.onnx.sha256").read_text(encoding="ascii")
    assert neighbour == digest + "\n"
    assert hashlib.sha256(path.read_bytes()).hexdigest() == digest


def test_the_file_has_what_is_told_and_half_the_bytes(
    written: tuple[LabelsNetwork, Path, str],
) -> None:
    network, path, _ = written
    stated = {
        metadata_prop.key: metadata_prop.value for metadata_prop in onnx.load(path).metadata_props
    }
    assert stated == {"temperature": "0.8"}
    count = sum(parameter.numel() for parameter in network.parameters())
    assert path.stat().st_size < 2.1 * count


def test_the_shipped_network_is_whole_and_loads() -> None:
    folder = files("gaussiancad_core.sheet.labels")
    data = folder.joinpath("labels.onnx").read_bytes()
    wanted = folder.joinpath("labels.onnx.sha256").read_text(encoding="ascii").strip()
    assert hashlib.sha256(data).hexdigest() == wanted
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = 1
    shipped = onnxruntime.InferenceSession(data, options, providers=["CPUExecutionProvider"])
    (logits,) = shipped.run(None, {"ink": np.zeros((1, 1, 64, 96), np.float32)})
    assert logits.shape == (1, OUTPUTS, 64, 96)
    assert (logits[0, : len(InkClass)].argmax(axis=0) == InkClass.PAPER).all()
