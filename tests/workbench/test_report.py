"""Reports as data."""

import json

from fake_engine import report as fake_report
from fake_part import BOXES, MM_PER_PIXEL
from support import FolderCase

from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import Remark, read_comparison, read_report
from freecad.gaussiancad.engine.summary import report_lines
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError


class Reports(FolderCase):
    def write(self, values: object) -> None:
        text = values if isinstance(values, str) else json.dumps(values)
        (self.folder / "report.json").write_text(text, encoding="utf-8")

    def test_a_whole_report(self) -> None:
        reason = {"code": "ambiguous", "message": "两种读法"}
        self.write(fake_report("a.png", "approximate", [reason]))
        report = read_report(self.folder / "report.json")
        self.assertIs(report.status, Status.APPROXIMATE)
        self.assertEqual(report.reasons, (Remark("ambiguous", "两种读法"),))
        self.assertEqual({view.role: view.box for view in report.views}, BOXES)
        self.assertEqual(report.views[0].agreement["hidden_recall"], 0.97)
        self.assertEqual(report.mm_per_pixel, MM_PER_PIXEL)
        self.assertEqual(sum(report.seconds.values()), 3.75)
        self.assertEqual(json.loads(report.text), report.values)
        lines = report_lines(report)
        self.assertIn("• 两种读法", lines)
        self.assertIn(
            "front: visible lines 99.8% found, 100.0% right; hidden lines 97.0% found, 99.0% right",
            lines,
        )

    def test_the_least_report(self) -> None:
        self.write({"status": "failed"})
        report = read_report(self.folder / "report.json")
        self.assertEqual((report.reasons, report.views, report.seconds), ((), (), {}))
        self.assertIsNone(report.mm_per_pixel)
        self.assertEqual(report_lines(report), [])

    def test_fields_of_the_wrong_type_are_left_out(self) -> None:
        boxes = [None, [1, 2, 3], [3, 0, 1, 1], [0, 0, "a", 1], [0, 0, 1, float("inf")]]
        views = {str(number): {"box": box} for number, box in enumerate(boxes)}
        values = {"status": "verified", "views": views, "seconds": [1], "reasons": ["x", 3]}
        self.write(values)
        report = read_report(self.folder / "report.json")
        self.assertEqual([view.box for view in report.views], [None] * len(boxes))
        self.assertEqual((report.seconds, report.reasons), ({}, ()))

    def test_what_is_no_report_is_told(self) -> None:
        for content in ("", "{", "[]", "3", '{"status": "great"}', "{}"):
            self.write(content)
            with self.assertRaises(WorkbenchError) as caught:
                read_report(self.folder / "report.json")
            self.assertIs(caught.exception.code, ErrorCode.RESULT_UNREADABLE)
        with self.assertRaises(WorkbenchError):
            read_report(self.folder / "missing.json")

    def test_a_comparison(self) -> None:
        values = {"chamfer": 0.3, "emd": None, "volume_iou": 0.9, "floor": {"chamfer": 0.2}}
        self.write(values)
        comparison = read_comparison(self.folder / "report.json")
        self.assertEqual(comparison.distances, {"chamfer": 0.3, "volume_iou": 0.9})
        self.assertEqual(comparison.floor, {"chamfer": 0.2})
        self.write({"schema": 1})
        with self.assertRaises(WorkbenchError):
            read_comparison(self.folder / "report.json")
