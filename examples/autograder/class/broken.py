"""Draws a polygon that no scene has."""
print('{"kind": "draw", "pieces": ["999"]}')
