# SPDX-License-Identifier: Apache-2.0
"""The schema of `pipeline schema` and `pipeline check` agree: both accept every shipped pipeline, and
both reject what is structurally wrong. Usage: check_schema.py PIPELINE_PROGRAM PIPELINES_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"SKIPPED: the schema test needs python3-jsonschema and python3-yaml ({missing})")
    sys.exit(77)

program, folder = sys.argv[1:]
schema = json.loads(subprocess.run([program, "schema"], check=True, capture_output=True).stdout)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
failures = []


def expect(name, text, sound):
    by_schema = validator.is_valid(yaml.safe_load(text))
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        file.write(text)
        file.flush()
        by_check = subprocess.run([program, "check", file.name], capture_output=True).returncode == 0
    if (by_schema, by_check) != (sound, sound):
        failures.append(f"{name}: should be {'sound' if sound else 'faulty'}; "
                        f"schema: {by_schema}, check: {by_check}")


shipped = sorted(pathlib.Path(folder).glob("*.yaml"))
for file in shipped:
    expect(file.name, file.read_text(), True)

base = """xgm: 1
matcher:
  type: semi_global
  cost: {type: census, window: 5}
  penalty: {type: constant, p1: 8, p2: 32}
  aggregation: {type: sgm, directions: 8}
"""
expect("base", base, True)
expect("filters", base + "  filters: [median, {type: median, window: 5}]\n", True)
expect("no refinement", base + "  refinement: null\n", True)
expect("disparities", base + "disparities: [-8, 8]\n", True)
for name, old, new in [
        ("misspelt stage", "census", "cenusus"),
        ("misspelt key", "window", "windw"),
        ("text for a number", "window: 5", "window: five"),
        ("quoted number", "window: 5", "window: '5'"),
        ("out of range", "window: 5", "window: 99"),
        ("even window", "window: 5", "window: 4"),
        ("wrong kind", "{type: census, window: 5}", "sgm"),
        ("missing stage", "  cost: {type: census, window: 5}\n", ""),
        ("list for a stage", "{type: census, window: 5}", "[census]"),
        ("unknown top key", "xgm: 1", "xgm: 1\nmatchers: 3"),
        ("wrong version", "xgm: 1", "xgm: 7"),
        ("no type", "type: census, ", ""),
]:
    assert old in base, old
    expect(name, base.replace(old, new), False)

print("\n".join(failures) or f"{len(shipped)} shipped pipelines and 16 others judged alike")
sys.exit(1 if failures or not shipped else 0)
