"""The roof over both houses: each module has one document made of a scene, and writes its file."""

from planes.documents import ours  # noqa: F401  (before anything of render)
