# SPDX-License-Identifier: Apache-2.0
"""The schema of `pipeline schema` and `pipeline check` agree on every value: for each parameter of each
plugin, the ends of its range and what lies beyond them, its choices and what lies between them, and
values of other types. Usage: check_values.py PIPELINE_PROGRAM"""
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError as missing:
    print(f"SKIPPED: the schema test needs python3-jsonschema ({missing})")
    sys.exit(77)

program = sys.argv[1]
schema = json.loads(subprocess.run([program, "schema"], check=True, capture_output=True).stdout)
validator = jsonschema.Draft7Validator(schema)

SEMI_GLOBAL = {"type": "semi_global", "cost": "census", "penalty": "constant", "aggregation": "sgm"}
SURE = {**SEMI_GLOBAL, "confidence": "agreement"}  # some filters need one
# What a plugin cannot be without: stages, and lists whose lengths depend on each other.
NEEDED = {
    ("matcher", "semi_global"): SEMI_GLOBAL,
    ("matcher", "left_right"): {"matcher": SEMI_GLOBAL},
    ("matcher", "pyramid"): {"matcher": SEMI_GLOBAL},
    ("pointing", "ground_control"): {"points": "points.csv"},
    ("cost", "weighted_sum"): {"costs": ["census"], "weights": [1]},
    ("confidence", "weighted"): {"confidences": ["agreement"], "weights": [1]},
    **{(kind, "external"): {"command": ["true"]} for kind in ("matcher", "cost", "filter")},
    **{(kind, "precomputed"): {"file": "map"} for kind in ("matcher", "cost")},
}
# One number for each of the stages, one of them above 0; the name of a program: a schema cannot say
# that.
RELATED = {("weighted_sum", "weights"), ("weighted", "weights"), ("external", "command")}


# The families of pipelines, by their names, and what they have at their top.
FAMILIES = {family["properties"]["type"]["const"]: family["properties"]
            for family in schema.get("anyOf", [schema])}
SURFACE = {"type": "surface", "matching": "sgm8.yaml"}


def pipeline_with(kind, stage):
    """A pipeline that has this stage."""
    if kind == "pipeline" and stage["type"] == "surface":
        return {**SURFACE, **stage}
    if kind in FAMILIES.get("surface", {}) and kind != "matcher":
        return {**SURFACE, kind: stage}
    if kind == "pipeline":
        return {"matcher": SEMI_GLOBAL, **{k: v for k, v in stage.items() if k != "type"}}
    if kind in ("filter", "preprocess"):
        return {"matcher": SURE, {"filter": "postprocess"}.get(kind, kind): [stage]}
    if kind == "matcher":
        return {"matcher": stage}
    if kind == "consistency" or stage["type"] == "left_right_difference":
        return {"matcher": {"type": "left_right", "matcher": SEMI_GLOBAL, kind: stage}}
    if kind == "search_range":
        return {"matcher": {"type": "pyramid", "matcher": SEMI_GLOBAL, kind: stage}}
    return {"matcher": {**SEMI_GLOBAL, kind: stage}}


def numbers(field):
    """At, between and beyond what the schema says of a number, and what a hidden rule would refuse."""
    values = {0, 1, -1, 2, 3, 0.5}
    for near in [field["minimum"], field["maximum"]] if "minimum" in field else []:
        values |= {near + step for step in (-1, -0.5, -0.01, 0, 0.01, 0.5, 1, 2)}
    values |= {near + step for near in field.get("enum", []) for step in (-1, 0, 1)}
    if field.get("maximum", 0) - field.get("minimum", 0) <= 64:
        values |= set(range(int(field.get("minimum", 0)), int(field.get("maximum", 0)) + 1))
    whole = field["type"] == "integer"  # in YAML, 5.0 is no whole number; in JSON, it is
    return [int(v) if whole and v == int(v) else v for v in sorted(values)]


def candidates(field):
    """Values of all types, and for numbers and lists those that matter."""
    yield from ("no such word", True, None, {}, [[]])
    if "enum" in field and "type" not in field:
        yield from field["enum"]
        yield field["enum"][0] + "x"
    elif field.get("type") == "array":
        some = [v for v in numbers(field["items"])]
        yield from ([], [0], [0, 0], [0, 1, 2], ["a", 1])
        yield from ([0, v] if v >= 0 else [v, 0] for v in some)
    elif field.get("type") in ("integer", "number"):
        yield from numbers(field)


def parameters():
    """Kind, plugin, its value fields."""
    plugins = [("pipeline", family, {k: v for k, v in top.items() if k not in ("type", "xgm")})
               for family, top in FAMILIES.items()]
    for kind, definition in schema["definitions"].items():
        plugins += [(kind, entry["properties"]["type"]["const"], entry["properties"])
                    for entry in definition["anyOf"] if "properties" in entry]
    for kind, plugin, fields in plugins:
        yield kind, plugin, {name: field for name, field in fields.items() if "default" in field}


def accepted(stages):
    """Which of the (kind, stage) `pipeline check` accepts."""
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for i, (kind, stage) in enumerate(stages):
            files.append(pathlib.Path(folder, f"{i}.yaml"))
            files[-1].write_text(json.dumps(pipeline_with(kind, stage)))
        good = set()
        for i in range(0, len(files), 500):
            told = subprocess.run([program, "check", *map(str, files[i:i + 500])],
                                  capture_output=True, text=True).stdout
            good |= {line.removesuffix(": ok") for line in told.splitlines()}
        return [str(file) in good for file in files]


def with_others(fields, name):
    """The other numbers of a plugin at either end: some choice of them keeps all relations."""
    others = [n for n, f in fields.items() if n != name and "minimum" in f]
    for ends in itertools.product(("minimum", "maximum"), repeat=min(len(others), 6)):
        chosen = {}
        for other, end in zip(others, ends):
            value, odd = fields[other][end], "not" in fields[other]
            whole = fields[other]["type"] == "integer"
            value = int(value) if whole else value
            chosen[other] = value if not odd or value % 2 else value + 1
        yield chosen


cases = []
for kind, plugin, fields in parameters():
    base = {**NEEDED.get((kind, plugin), {}), "type": plugin}
    for name, field in fields.items():
        if (plugin, name) in RELATED:
            continue
        cases += [(kind, plugin, fields, name, {**base, name: value}) for value in candidates(field)]
by_check = accepted([(kind, stage) for kind, _, _, _, stage in cases])
failures = []
for (kind, plugin, fields, name, stage), checked in zip(cases, by_check):
    by_schema = validator.is_valid(pipeline_with(kind, stage))
    if by_schema and not checked:  # a relation to other parameters may be broken: is there none?
        others = [(kind, {**other, **stage}) for other in with_others(fields, name)]
        checked = any(accepted(others))
    if by_schema != checked:
        failures.append(f"{kind} {plugin}: {name} = {stage[name]!r}: schema {by_schema}, check {checked}")

print("\n".join(failures) or f"{len(cases)} values judged alike, {sum(by_check)} of them right")
sys.exit(1 if failures or not 0 < sum(by_check) < len(cases) else 0)
