"""Runs of the fake engine: watched, cancelled, killed, broken."""

import os
import signal
import threading
import time

from support import FAKE_ENGINE, FolderCase, alive, draw_sheet, run_fake

from freecad.gaussiancad.engine.job import CompareJob, ReconstructJob
from freecad.gaussiancad.engine.locate import Engine, EngineSource
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.protocol import Event, EventKind
from freecad.gaussiancad.engine.verdict import RunState


class Runs(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.output = self.folder / "out"
        self.sheet = draw_sheet(self.folder / "sheet.png")
        self.job = ReconstructJob(str(self.sheet), str(self.output))

    def run_until_second_stage(self, job_arguments: list[str], act: str) -> RunResult:
        """Start a run, call its method (or send a signal) in the second stage, wait."""
        runs: list[EngineRun] = []

        def on_event(event: Event) -> None:
            if event.kind is EventKind.STAGE and event.number("index") == 2:
                if act == "cancel":
                    runs[0].cancel()
                else:
                    os.kill(runs[0].pid, signal.Signals[act])

        runs.append(EngineRun(FAKE_ENGINE, job_arguments, Watcher(on_event), grace=0.3))
        runs[0].start()
        result = runs[0].wait()
        self.assertFalse(runs[0].running)
        return result

    def test_a_run_tells_all_its_events_in_order(self) -> None:
        result, events, log = run_fake(self.job.arguments())
        self.assertIs(result.state, RunState.DONE)
        self.assertEqual((result.exit_code, result.message), (0, ""))
        stages = [e.text("name") for e in events if e.kind is EventKind.STAGE]
        self.assertEqual(stages, ["read", "solid", "gaussians"])
        self.assertEqual(sum(e.kind is EventKind.PROGRESS for e in events), 12)
        self.assertIs(events[0].kind, EventKind.HELLO)
        self.assertIs(events[-1].kind, EventKind.RESULT)
        self.assertEqual(events[-1].text("path"), str(self.output / "report.json"))
        self.assertEqual(log, ["solving cells"])

    def test_noise_between_the_events_is_no_harm(self) -> None:
        self.behave("noisy")
        result, events, log = run_fake(self.job.arguments())
        self.assertIs(result.state, RunState.DONE)
        self.assertEqual(sum(e.kind is EventKind.PROGRESS for e in events), 12)
        self.assertIn("文件 café", log)

    def test_a_cancelled_run_ends_as_cancelled_and_writes_nothing(self) -> None:
        self.behave("slow")
        result = self.run_until_second_stage(self.job.arguments(), "cancel")
        self.assertIs(result.state, RunState.CANCELLED)
        self.assertEqual(result.exit_code, 130)
        self.assertFalse(self.output.exists())

    def test_an_engine_that_does_not_listen_is_killed(self) -> None:
        self.behave("deaf")
        result = self.run_until_second_stage(self.job.arguments(), "cancel")
        self.assertIs(result.state, RunState.CANCELLED)
        self.assertEqual(result.exit_code, -1)

    def test_an_engine_killed_from_outside_is_told_as_that(self) -> None:
        self.behave("slow")
        for act in ("SIGKILL", "SIGSEGV"):
            result = self.run_until_second_stage(self.job.arguments(), act)
            self.assertIs(result.state, RunState.KILLED)
            self.assertIn("ended from outside", result.message)
        self.behave("dies")
        result, _, _ = run_fake(self.job.arguments())
        self.assertIs(result.state, RunState.KILLED)

    def test_a_refusal_comes_with_the_engines_own_sentence(self) -> None:
        self.behave("refuse")
        result, _, _ = run_fake(self.job.arguments())
        self.assertIs(result.state, RunState.FAILED)
        self.assertEqual((result.exit_code, result.code), (4, "one-view"))
        self.assertEqual(result.message, "only one view was found: draw at least two")

    def test_a_module_that_is_missing_means_a_broken_engine(self) -> None:
        self.behave("broken")
        result, _, _ = run_fake(self.job.arguments())
        self.assertIs(result.state, RunState.BROKEN)
        self.assertIn("No module named gaussiancad_core", result.message)

    def test_an_interpreter_that_cannot_start_means_a_broken_engine(self) -> None:
        not_a_program = self.folder / "python"
        not_a_program.write_bytes(b"\x7fELF nothing")
        not_a_program.chmod(0o755)
        for path in (not_a_program, self.folder / "missing"):
            run = EngineRun(Engine(str(path), EngineSource.PREFERENCE), self.job.arguments())
            run.start()
            result = run.wait()
            self.assertIs(result.state, RunState.BROKEN)
            self.assertIn(str(path), result.message)

    def test_the_keyboard_cancels_a_run_that_is_waited_for(self) -> None:
        self.behave("slow")
        run = EngineRun(FAKE_ENGINE, self.job.arguments())
        run.start()
        main_thread = threading.main_thread().ident
        timer = threading.Timer(0.5, signal.pthread_kill, (main_thread, signal.SIGINT))
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        timer.start()
        self.assertIs(run.wait().state, RunState.CANCELLED)

    def test_what_is_flushed_arrives_though_nobody_looks_at_the_process(self) -> None:
        self.behave("slow")
        run = EngineRun(FAKE_ENGINE, self.job.arguments())
        run.start()
        run.cancel()
        run.flush()
        deadline = time.monotonic() + 15.0
        pid = run.pid
        while alive(pid):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)
        self.assertIs(run.wait().state, RunState.CANCELLED)

    def test_a_command_without_events_is_ended_by_a_signal(self) -> None:
        self.behave("slow")
        arguments = CompareJob(str(self.sheet), str(self.sheet), str(self.output)).arguments()
        run = EngineRun(FAKE_ENGINE, arguments, grace=0.3)
        run.start()
        while run.pid == 0:
            time.sleep(0.01)
        run.cancel()
        self.assertIs(run.wait().state, RunState.CANCELLED)
        self.assertFalse(self.output.exists())

    def test_an_error_without_events_is_taken_from_the_log(self) -> None:
        arguments = CompareJob("none.step", "none.stl", str(self.output)).arguments()
        result, _, _ = run_fake(arguments)
        self.assertIs(result.state, RunState.FAILED)
        self.assertEqual((result.exit_code, result.code), (3, "model-missing"))
        self.assertEqual(result.message, "there is no file none.step")

    def test_the_output_of_a_command_without_events_is_kept(self) -> None:
        result, events, _ = run_fake(["doctor"])
        self.assertIs(result.state, RunState.DONE)
        self.assertEqual(events, [])
        self.assertIn("torch: missing", result.output)

    def test_the_child_does_not_get_the_bundles_python(self) -> None:
        self.set_variable("PYTHONHOME", "/nowhere")
        self.set_variable("LD_PRELOAD", "/nowhere/lib.so")
        result, _, _ = run_fake(self.job.arguments())
        self.assertIs(result.state, RunState.DONE)
