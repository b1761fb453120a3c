"""Drawings handed in: read (``reading, vision``), judged (``grading``), and told (``outcome``, ``report``)."""
