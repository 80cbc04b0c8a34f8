"""Lines and events out of a stream that may hold anything."""

import json
import random
import unittest

from gaussiancad_protocol.event_lines import (
    LONGEST_LINE,
    Event,
    EventKind,
    LineBuffer,
    parse_event,
)


class Lines(unittest.TestCase):
    def test_any_cutting_of_the_stream_gives_the_same_lines(self) -> None:
        lines = ["stage 零件", "", "é" * 50, '{"event": "hello"}', "last"]
        stream = "\r\n".join(lines).encode("utf-8") + b"\n"
        chance = random.Random(3)
        for _ in range(50):
            buffer, found, place = LineBuffer(), [], 0
            while place < len(stream):
                step = chance.randint(1, 9)
                found += buffer.feed(stream[place : place + step])
                place += step
            self.assertEqual(found + buffer.rest(), lines)

    def test_a_stream_without_a_last_line_end_is_read_to_its_end(self) -> None:
        buffer = LineBuffer()
        self.assertEqual(buffer.feed(b"a\nb"), ["a"])
        self.assertEqual(buffer.rest(), ["b"])
        self.assertEqual(buffer.rest(), [])

    def test_bytes_that_are_no_text_are_replaced(self) -> None:
        self.assertEqual(LineBuffer().feed(b"\xff\xfe\n"), ["\ufffd\ufffd"])

    def test_an_endless_line_is_dropped_and_the_next_one_is_read(self) -> None:
        buffer = LineBuffer()
        self.assertEqual(buffer.feed(b"x" * (LONGEST_LINE + 1)), [])
        self.assertEqual(buffer.feed(b"xxx\nnext\n"), ["next"])


class Events(unittest.TestCase):
    def test_every_kind_is_read(self) -> None:
        for kind in EventKind:
            line = json.dumps({"event": kind.value, "name": "solid", "fraction": 0.5})
            self.assertEqual(parse_event(line), Event(kind, {"name": "solid", "fraction": 0.5}))

    def test_everything_else_is_no_event(self) -> None:
        noise = ["", "text", "[]", "3", "null", "{}", '{"event": "party"}', '{"event": 3}']
        noise += ['{"event": ["hello"]}', '{"event": "hello"', "[" * 100_000]
        for line in noise:
            self.assertIsNone(parse_event(line), line[:30])

    def test_fields_of_the_wrong_type_do_no_harm(self) -> None:
        event = Event(EventKind.PROGRESS, {"fraction": "x", "eta_s": True, "loss": float("nan")})
        self.assertIsNone(event.number("fraction"))
        self.assertIsNone(event.number("eta_s"))
        self.assertIsNone(event.number("loss"))
        self.assertEqual(event.text("missing"), "")
