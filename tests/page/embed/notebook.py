"""A notebook's kernel with one widget, w.

Each line that comes has what a browser has told of the traits, then Python to run; the answer is what the widget has then.
"""

import base64
import json
import sys

names = {}
for line in sys.stdin:
    asked = json.loads(line)
    if asked["traits"]:
        names["w"].set_state(asked["traits"])
    exec(asked["code"], names)
    w = names["w"]
    traits = w.get_state()
    traits["_page"] = base64.b64encode(traits["_page"]).decode()
    print(json.dumps({"traits": traits, "history": w.history, "error": w.error}), flush=True)
