"""The table of figures: printed, written as JSON, and held against that of an earlier run."""

import json
import os
import re

MARGIN = 0.15  # what differs by less is noise


def better(figure):
    """How good a figure such as "0.46", "1/10.4", "36 / s" or "1.2 s" is, more being better; None where it is no number."""
    match = re.fullmatch(r"(1/)?([\d.,]+)( / s)?(?: [a-zA-Z]+)?", figure or "")
    if not match or not (number := float(match[2].replace(",", ""))):
        return None
    return number if match[1] or match[3] else 1 / number


class Table:
    def __init__(self):
        self.rows, self.above = [], ""

    def row(self, what, figure, peer="", ratio="", goal="", reached=None):
        """`what` begins with two spaces where it says more of the row above."""
        if not what.startswith("  "):
            self.above = what
        name = what if what == self.above else f"{self.above}: {what.strip()}"
        self.rows.append({"name": name, "what": what, "figure": figure, "peer": peer, "ratio": ratio, "goal": goal, "reached": reached})

    def write(self, path):
        with open(path, "w", encoding="utf-8") as out:
            json.dump({"processors": os.cpu_count(), "load": os.getloadavg()[0], "rows": self.rows}, out, indent=1, ensure_ascii=False)
            out.write("\n")

    def hold_against(self, path):
        """Adds what the earlier run had, and which are worse now: by the ratio to a peer where both have one."""
        with open(path, encoding="utf-8") as file:
            earlier = {row["name"]: row for row in json.load(file)["rows"]}
        for row in self.rows:
            before = earlier.get(row["name"])
            if not before:
                continue
            key = "ratio" if better(row["ratio"]) and better(before["ratio"]) else "figure"
            row["before"] = before[key]
            was, now = better(before[key]), better(row[key])
            row["worse"] = bool(was and now and now < was * (1 - MARGIN))

    def any_worse(self):
        return any(row.get("worse") for row in self.rows)

    def print(self):
        before = any("before" in row for row in self.rows)
        lines = [["what", "normalscope", "f3d", "ratio", "to reach", *(["before"] if before else []), ""]]
        for row in self.rows:
            said = [{True: "ok", False: "not", None: ""}[row["reached"]], "worse" if row.get("worse") else ""]
            lines.append([row["what"], row["figure"], row["peer"], row["ratio"], row["goal"],
                          *([row.get("before", "")] if before else []), " ".join(filter(None, said))])
        widths = [max(map(len, column)) for column in zip(*lines)]
        for line in lines:
            cells = [line[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(line[1:-1], widths[1:-1])), line[-1]]
            print("  ".join(cells).rstrip())
