# Checks the JSON files of a folder by the schema.json in it: right-*.json must pass, wrong-*.json must not.
import json, pathlib, sys
import jsonschema

folder = pathlib.Path(sys.argv[1])
schema = json.loads((folder / "schema.json").read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
failures = [file.name for file in sorted(folder.glob("*-*.json"))
            if validator.is_valid(json.loads(file.read_text())) != file.name.startswith("right")]
print("off:", failures) if failures else None
sys.exit(1 if failures else 0)
