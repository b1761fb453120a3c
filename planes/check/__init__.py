"""Checks submitted drawings: reads them (``reading, vision``), judges (``grading``), reports (``outcome, report``)."""
