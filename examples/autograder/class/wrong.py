"""A painter that sorts by the nearest corner: some orders are wrong."""
import json
import sys

with open(sys.argv[1], encoding="utf-8") as file:
    polygons = [p for p in json.load(file)["polygons"] if p["outline"]]
for polygon in sorted(polygons, key=lambda p: -p["nearest"]):
    print(json.dumps({"kind": "draw", "pieces": [str(polygon["id"])]}))
