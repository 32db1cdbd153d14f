#!/usr/bin/env python3
"""Plans random boxes of 1 km2 on an ENC cell and checks each route against the raw chart.

    tests/charts/hazard_boxes.py PROGRAM CELL.000 [BOXES] [SEED] [near]

With 'near' each box lies about a random hazard, within 400 m of it.

Needs ogr2ogr (gdal-bin) and nothing else. What the boat must keep is worked out here anew, from the
layers, spatial records and quality zones that GDAL reads, in plain Python: none of the program's
code and no geometry library takes part. Legs that the plan marks infeasible (no way through the water)
are told in metres and not held against the hazards: no mission is exported with them. Exits with 1 if any route comes nearer to a hazard than its
buffer, or if a plan fails for another reason than a box without water.
"""
import csv, json, math, os, random, subprocess, sys, tempfile, time

BASE = {"LNDARE": 10, "SLCONS": 10, "PONTON": 10, "RESARE": 0, "WRECKS": 20, "OBSTRN": 10, "UWTROC": 10}
DANGERS = ("WRECKS", "OBSTRN", "UWTROC")
QUAPOS = {2: 100, 3: 100, 9: 100, 4: 30.5, 5: 200, 6: 200, 7: 200, 8: 200}
CATZOC = {1: 10, 2: 20, 3: 50, 4: 500, 5: 500}
PLAN = ["--planner", "back-and-forth", "--spacing", "50", "--resolution", "10", "--hit-only"]


def layer(cell, name, crs, folder):
    out = os.path.join(folder, name + crs.replace(":", "") + ".geojson")
    if not os.path.exists(out) or os.path.getsize(out) == 0:
        env = dict(os.environ, OGR_S57_OPTIONS="UPDATES=APPLY,SPLIT_MULTIPOINT=ON,LIST_AS_STRING=ON,"
                                               "RETURN_PRIMITIVES=ON,RETURN_LINKAGES=ON")
        done = subprocess.run(["ogr2ogr", "-f", "GeoJSON", out, cell, name, "-t_srs", crs,
                               "-lco", "COORDINATE_PRECISION=9"], env=env, capture_output=True, text=True)
        if done.returncode != 0:
            if "Couldn't fetch requested layer" not in done.stderr:
                sys.exit(done.stderr)
            with open(out, "w", encoding="utf-8") as f:
                f.write('{"features": []}')  # the cell holds none
    with open(out, encoding="utf-8") as f:
        return json.load(f)["features"]


def parts(geometry):
    """(rings of polygons, open lines and points)"""
    kind, at = geometry["type"], geometry["coordinates"]
    if kind == "Point":
        return [], [[at]]
    if kind == "LineString":
        return [], [at]
    if kind in ("MultiPoint",):
        return [], [[p] for p in at]
    if kind == "MultiLineString":
        return [], at
    if kind == "Polygon":
        return [at], []
    return at, []  # MultiPolygon


def inside(rings, x, y):
    odd = False
    for ring in rings:
        for (ax, ay, *_), (bx, by, *_) in zip(ring, ring[1:]):
            if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
                odd = not odd
    return odd


def between(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    n = dx * dx + dy * dy
    t = 0 if n == 0 else max(0, min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / n))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def segments_apart(a, b, c, d):
    if cross(a, b, c) * cross(a, b, d) < 0 and cross(c, d, a) * cross(c, d, b) < 0:
        return 0.0
    return min(between(a, c, d), between(b, c, d), between(c, a, b), between(d, a, b))


CELL_M = 50.0


class Track:
    """A route's segments in square cells, so that those near a place are found without all others."""

    def __init__(self, route, sailed):
        """`sailed`: whether each segment is; those that are not do not count."""
        self.route, self.cells = route, {}
        for i, (a, b) in enumerate(zip(route, route[1:])):
            if not sailed[i]:
                continue
            for cell in self.over((min(a[0], b[0]), min(a[1], b[1])), (max(a[0], b[0]), max(a[1], b[1]))):
                self.cells.setdefault(cell, []).append(i)
        # Where sailing begins, and begins again behind a leg that is not sailed.
        self.entries = [route[i] for i in range(len(route) - 1) if sailed[i] and (i == 0 or not sailed[i - 1])]
        self.low = [min(p[k] for p in route) for k in (0, 1)]
        self.high = [max(p[k] for p in route) for k in (0, 1)]

    @staticmethod
    def over(low, high):
        first, last = [[int(v // CELL_M) for v in p] for p in (low, high)]
        return [(i, j) for i in range(first[0], last[0] + 1) for j in range(first[1], last[1] + 1)]

    def near(self, low, high):
        """Segments whose cells meet the box."""
        low = [max(low[k], self.low[k]) for k in (0, 1)]
        high = [min(high[k], self.high[k]) for k in (0, 1)]
        found = {i for cell in self.over(low, high) for i in self.cells.get(cell, ())}
        return [(self.route[i], self.route[i + 1]) for i in sorted(found)]


def distance(track, shape, reach):
    """The least distance of the route from the shape; anything beyond `reach` counts as that."""
    polygons, lines = shape
    least = reach
    low = [track.low[k] - reach for k in (0, 1)]
    high = [track.high[k] + reach for k in (0, 1)]
    chains = [ring for rings in polygons for ring in rings] + lines
    for rings in polygons:
        if any(inside(rings, *p) for p in track.entries):  # from there on an outline would be crossed
            return 0.0
    for chain in chains:
        for c, d in zip(chain, chain[1:] if len(chain) > 1 else chain):
            if min(c[0], d[0]) > high[0] or max(c[0], d[0]) < low[0]:
                continue
            if min(c[1], d[1]) > high[1] or max(c[1], d[1]) < low[1]:
                continue
            for a, b in track.near([min(c[k], d[k]) - least for k in (0, 1)], [max(c[k], d[k]) + least for k in (0, 1)]):
                if min(a[0], b[0]) - least > max(c[0], d[0]) or max(a[0], b[0]) + least < min(c[0], d[0]):
                    continue
                if min(a[1], b[1]) - least > max(c[1], d[1]) or max(a[1], b[1]) + least < min(c[1], d[1]):
                    continue
                least = min(least, segments_apart(a, b, c, d))
    return least


def number_list(text):
    text = str(text or "")
    text = text[text.index(":") + 1:] if ":" in text else text
    return [int(t) for t in text.strip("()").split(",") if t.strip().lstrip("-").isdigit()]


def closed(properties):
    restrictions, kinds = number_list(properties.get("RESTRN")), number_list(properties.get("CATREA"))
    if restrictions:
        return any(r in (7, 8, 14) for r in restrictions)
    return not kinds or any(k in (1, 9, 12, 14) for k in kinds)


class Hazard:
    """A hazard of the chart. Its buffer is worked out when a box first comes near."""

    def __init__(self, name, shape, accuracy):
        self.name, self.shape, self.accuracy, self.buffer_m = name, shape, accuracy, None
        places = [p for rings in shape[0] for p in rings[0]] + [p for line in shape[1] for p in line]
        self.low = [min(p[k] for p in places) for k in (0, 1)]
        self.high = [max(p[k] for p in places) for k in (0, 1)]

    def buffer(self):
        if self.buffer_m is None:
            self.buffer_m = BASE[self.name] + self.accuracy()
        return self.buffer_m

    def near(self, route, room):
        return all(min(p[k] for p in route) - room <= self.high[k] and
                   max(p[k] for p in route) + room >= self.low[k] for k in (0, 1))


def accuracy_of(name, place, records, zones, scale):
    posacc = [r[0] for r in records if r[0]]
    if posacc:
        return max(posacc)
    accuracy = max([0.0003 * scale] + [QUAPOS.get(r[1], 0) for r in records])
    if name in DANGERS:
        polygons, lines = parts(place["geometry"])
        for q in [q for rings in polygons for q in rings[0]] + [q for line in lines for q in line]:
            for zone, rings in zones:
                if any(inside(r, q[0], q[1]) for r in rings):
                    accuracy = max(accuracy, CATZOC.get(zone, 0))
    return accuracy


def hazards(cell, crs, folder):
    scale = layer_scale(cell)
    stated = {}
    for kind, number in (("IsolatedNode", 110), ("ConnectedNode", 120), ("Edge", 130)):
        for f in layer(cell, kind, "EPSG:4326", folder):
            stated[(number, f["properties"]["RCID"])] = (f["properties"].get("POSACC"), f["properties"].get("QUAPOS"))
    zones = [(f["properties"]["CATZOC"], parts(f["geometry"])[0]) for f in layer(cell, "M_QUAL", "EPSG:4326", folder)
             if f["properties"].get("CATZOC")]
    found = []
    for name, base in BASE.items():
        for place, f in zip(layer(cell, name, "EPSG:4326", folder), layer(cell, name, crs, folder)):
            p = f["properties"]
            if f["geometry"] is None or (name == "RESARE" and not closed(p)):
                continue
            kinds, numbers = p.get("NAME_RCNM") or [], p.get("NAME_RCID") or []
            records = [stated.get(key, (None, None)) for key in zip(kinds, numbers)]
            found.append(Hazard(name, parts(f["geometry"]),
                                lambda n=name, q=place, r=records: accuracy_of(n, q, r, zones, scale)))
    return found


def layer_scale(cell):
    text = subprocess.run(["ogrinfo", "-q", cell, "DSID"], capture_output=True).stdout.decode("latin-1")
    return float(text.split("DSPM_CSCL (Integer) = ")[1].split()[0])


def main():
    program, cell = sys.argv[1], sys.argv[2]
    boxes = int(sys.argv[3]) if len(sys.argv) > 3 else 20
    chance = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 15)
    near_hazards = sys.argv[5:] == ["near"]
    bad, rows, tried = 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        areas = [(parts(f["geometry"])[0], f["properties"].get("DRVAL1")) for f in layer(cell, "DEPARE", "EPSG:4326", folder)]
        all_places = [p for polygons, _ in areas for rings in polygons for p in rings[0]]
        low = [min(p[k] for p in all_places) for k in (0, 1)]
        high = [max(p[k] for p in all_places) for k in (0, 1)]
        zone = 32600 + int((0.5 * (low[0] + high[0]) + 180) // 6) + 1
        chart = hazards(cell, f"EPSG:{zone}", folder)
        places = []  # a corner of each hazard
        for name in BASE if near_hazards else ():
            for f in layer(cell, name, "EPSG:4326", folder):
                if f["geometry"] is not None and (name != "RESARE" or closed(f["properties"])):
                    polygons, lines = parts(f["geometry"])
                    places.append((polygons[0][0] if polygons else lines[0])[0])
        print("box lon lat hazards_near route_km infeasible_m cpu_s least_room_m nearest_class", flush=True)
        while rows < boxes and tried < 50 * boxes:
            tried += 1
            lon, lat = chance.uniform(low[0], high[0]), chance.uniform(low[1], high[1])
            if near_hazards:
                place = chance.choice(places)
                lon = place[0] + chance.uniform(-0.4, 0.4) / (111.32 * math.cos(math.radians(place[1])))
                lat = place[1] + chance.uniform(-0.4, 0.4) / 110.95
            dx, dy = 0.5 / (111.32 * math.cos(math.radians(lat))), 0.5 / 110.95
            if not any(s is not None and s >= 1.8 and any(inside(r, lon, lat) for r in polygons) for polygons, s in areas):
                continue
            ring = [[lon - dx, lat - dy], [lon + dx, lat - dy], [lon + dx, lat + dy], [lon - dx, lat + dy], [lon - dx, lat - dy]]
            area = os.path.join(folder, "box.geojson")
            with open(area, "w", encoding="utf-8") as f:
                json.dump({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [ring]}}, f)
            out = os.path.join(folder, "out")
            before = os.times()
            run = subprocess.run([program, "plan", cell, "--area", area, "-o", out] + PLAN, capture_output=True, text=True)
            after = os.times()
            cpu = after.children_user + after.children_system - before.children_user - before.children_system
            rows += 1
            if run.returncode != 0:
                said = run.stderr.strip().splitlines()[-1]
                no_water = "no water" in said
                bad += 0 if no_water else 1
                print(f"{rows} {lon:.4f} {lat:.4f} - - - {cpu:.1f} {'no water left: ' if no_water else 'FAILED: '}{said}", flush=True)
                continue
            with open(os.path.join(out, "route.csv"), encoding="utf-8") as f:
                table = list(csv.DictReader(line for line in f if not line.startswith("#")))
            route = [(float(r["x_m"]), float(r["y_m"])) for r in table]
            length = sum(math.dist(a, b) for a, b in zip(route, route[1:])) / 1000
            sailed = [r["status"] != "infeasible" for r in table]
            astray = sum(math.dist(a, b) for a, b, ok in zip(route, route[1:], sailed) if not ok)
            track = Track(route, sailed)
            near, least, which = 0, 1e9, "-"
            for hazard in (h for h in chart if h.near(route, 800)):
                buffer = hazard.buffer()
                apart = distance(track, hazard.shape, buffer + 200)
                near += apart < buffer + 200
                if apart < buffer + 200 and apart - buffer < least:
                    least, which = apart - buffer, hazard.name
            bad += least < 0
            room = f"{least:.2f}" if near else "-"
            print(f"{rows} {lon:.4f} {lat:.4f} {near} {length:.1f} {astray:.0f} {cpu:.1f} {room} {which}", flush=True)
    print(f"{rows} boxes, {bad} with a fault")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
