"""OSMesa is a backend of the first rank: its tests fail where the distribution has it and it does not work. Mesa ended it in 25.1, so
where the distribution has none they are left out, and say so."""
# SPDX-License-Identifier: MIT
import json
import subprocess

WITHOUT = "without OSMesa: this distribution's Mesa has none, it ended in 25.1"


def may_lack_osmesa(program):
    listed = subprocess.run([program, "list", "backends", "--json"], capture_output=True, check=True).stdout
    row = next(row for row in json.loads(listed)["backends"] if row["name"] == "osmesa")
    return not row["available"] and "libOSMesa.so.8 is missing" in row["reason"] and "Mesa ended OSMesa" in row["mend"]
