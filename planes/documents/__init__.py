"""The layer above engine and renderer: each module makes one document of a scene, and writes its file."""

from planes.documents import ours  # noqa: F401  (before anything of render)
