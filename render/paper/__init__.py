"""The paper and the elements on it: marks, pens, letters, symbols."""
