"""The machine of docs/manual.md in Python: one file a chapter, slow and plain."""
