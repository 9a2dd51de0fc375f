"""The pipelines of examples/ci: run_pipelines.py BIN-FOLDER SOURCE-FOLDER

Each file is YAML, its commands are shell. What installs is only read; all else runs as a runner would run it, in a
repository that has the files of examples/ci."""

import os
import re
import shutil
import subprocess
import sys

import yaml

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, 'bus_e2e'))
import programs  # noqa: E402  pylint: disable=wrong-import-position

FOLDER = 'examples/ci'
INSTALLS = re.compile(r'apt-get |(test -x \S+ \|\| )?\./install-axisd\.sh ')
TESTS = ('pytest-3 --junit-xml=report.xml test_drive.py', './drive.sh')
LONGEST = 120  # s


def github(pipeline):
    assert {'name', True, 'jobs'} <= pipeline.keys()  # YAML takes "on" for true
    for job in pipeline['jobs'].values():
        for step in job['steps']:
            assert ('run' in step) != ('uses' in step), step
            assert re.fullmatch(r'[\w-]+/[\w-]+@v\d+', step.get('uses', 'a/b@v1')), step
            yield step.get('run', '')


def gitlab(pipeline):
    for job in pipeline.values():
        yield '\n'.join(job['before_script'] + job['script'])


def azure(pipeline):
    for step in pipeline['steps']:
        assert ('script' in step) != ('task' in step), step
        yield step.get('script', '')


def run_step(script, folder, environment):
    """Runs the commands of a step but for those that install, whose form is looked at; the commands that ran."""
    subprocess.run(['bash', '-n'], input=script, text=True, check=True)
    lines = [line for line in script.split('\n') if line.strip() and not INSTALLS.match(line)]
    if lines:
        subprocess.run(['bash', '-e'], input='\n'.join(lines), text=True, check=True, cwd=folder, env=environment,
                       timeout=LONGEST, stdout=sys.stderr)
    return lines


def main():
    bin_folder, source = (os.path.abspath(word) for word in sys.argv[1:])
    names = sorted(name for name in os.listdir(os.path.join(source, FOLDER)) if name.endswith('.yml'))
    assert len(names) >= 3, names
    for name in names:
        with programs.Folder(bin_folder) as folder:
            with open(os.path.join(source, FOLDER, name), encoding='utf-8') as file:
                pipeline = yaml.safe_load(file)
            shutil.copytree(os.path.join(source, FOLDER), folder.path('repository'))
            environment = {**folder.environment, 'PATH': f'{bin_folder}:/usr/bin:{os.environ["PATH"]}'}
            ran = [line for script in globals()[name.removesuffix('.yml')](pipeline)
                   for line in run_step(script, folder.path('repository'), environment)]
            print(f'{name}: {ran}')
            for test in TESTS:
                assert any(test in line for line in ran), f'{name} does not run {test}'
            assert os.path.getsize(folder.path('repository/report.xml')) > 0
    return 0


sys.exit(main())
