"""Marks judged step by step, and the mistakes that explain them."""
