"""A job as options of the command line, for the process that does it."""

from gaussiancad_core.report.job import Job


def job_arguments(job: Job) -> list[str]:
    """Options of ``gaussiancad reconstruct`` that give the same job on another sheet."""
    settings = job.settings()
    arguments: list[str] = []
    for name in ("projection", "page", "recipe", "preset", "seed", "colour"):
        arguments += [f"--{name}", str(settings[name])]
    if not job.surface_left_out:
        # Else nothing was asked for, and each sheet's report warns of what is missing.
        arguments += ["--result", job.result.value]
    for role, box in settings["views"].items():
        arguments += ["--view", f"{role}={','.join(str(value) for value in box)}"]
    for axis, length in settings["lengths"].items():
        arguments += ["--length", f"{axis}={length}"]
    if settings["unit"]:
        arguments += ["--unit", settings["unit"]]
    if settings["mm_per_pixel"]:
        arguments += ["--mm-per-pixel", str(settings["mm_per_pixel"])]
    arguments += ["--median", str(settings["median_kernel"])]
    arguments += ["--device", job.device.value, "--scale-down", str(job.scale_down)]
    switches = {
        "--resume": job.resume,
        "--transforms": job.transforms,
        "--overwrite": job.overwrite,
    }
    return [*arguments, *(name for name, wanted in switches.items() if wanted)]
