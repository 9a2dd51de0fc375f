"""The client of examples/fleet/status.mjs before a farm; skipped (77) without its npm package.

usage: farm_npm.py PROGRAMS SCRIPT NODE_MODULES
"""
import pathlib
import shutil
import subprocess
import sys

import programs
from small_farm import Farm, wait_until

bin_folder, script, modules = sys.argv[1:4]
if not pathlib.Path(modules, "@nats-io/transport-node").exists():
    print("the npm package @nats-io/transport-node is not installed")
    sys.exit(77)


def run(folder, *words):
    return subprocess.run(["node", folder.path("status.mjs"), "nats://127.0.0.1:4222", "lab", *words], cwd=folder.folder.name,
                          capture_output=True, text=True, timeout=60, check=False)


with programs.Folder(bin_folder) as test_folder, Farm(test_folder) as farm:
    # Beside its packages, as one who has just installed them has it.
    shutil.copy(script, test_folder.path("status.mjs"))
    pathlib.Path(test_folder.path("node_modules")).symlink_to(modules)
    wait_until(lambda: len(farm.json("units")["units"]) == 2, "both hosts have told what they have")
    done = run(test_folder, "line1/5")
    assert done.stdout.splitlines()[:1] == ["line1/5: node 5, Pre-operational"], done
    done = run(test_folder, "line1/6", "load.set", '{"axis": 1, "torque_Nm": 2}')
    assert done.stdout.splitlines() == ["load.set: {}", "line1/6: node 6, Pre-operational",
                                        "axis 1: Switch on disabled, load 2 Nm"], done
    done = run(test_folder, "line1/6", "load.set", '{"axis": 9, "torque_Nm": 2}')
    assert done.returncode == 1 and "(bad-parameter)" in done.stderr, done
    print("a client that is not ours reads the status of a unit and sends it a method")
