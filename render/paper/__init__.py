"""The paper and what lies on it: marks, pens, letters, symbols."""
