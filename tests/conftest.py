"""Every run draws the same random scenes, and none is refused for what a busy machine takes to draw it."""

from __future__ import annotations

from hypothesis import HealthCheck, settings

settings.register_profile(
    "planes", derandomize=True, deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)  # fmt: skip
settings.load_profile("planes")
