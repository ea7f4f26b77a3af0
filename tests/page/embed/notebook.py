"""A notebook's kernel with one widget, w.

Each line that comes has what a browser has told of the traits, then Python to run; the answer is what the widget has then, and what Python refused.
"""

import base64
import json
import sys

names = {}
for line in sys.stdin:
    asked = json.loads(line)
    if asked["traits"]:
        names["w"].set_state(asked["traits"])
    refused = ""
    try:
        exec(asked["code"], names)
    except Exception as error:
        refused = f"{type(error).__name__}: {error}"
    w = names["w"]
    traits = w.get_state()
    traits["_page"] = base64.b64encode(traits["_page"]).decode()
    print(json.dumps({"traits": traits, "history": w.history, "error": w.error, "refused": refused}), flush=True)
