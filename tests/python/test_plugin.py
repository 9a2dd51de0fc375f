"""The plug-in of pytest: what a test that fails shows and leaves, options, marker, and tests side by side."""

import json
import os
import pathlib
import re
import shutil

pytest_plugins = 'pytester'
BESIDE = '-p', 'no:cacheprovider'
FAILS = '''
    def test_reads(drive):
        assert drive.sdo_read(0x1000, as_type=int) == 0xFFFF0192
        assert drive.sdo_read(0x1008, as_type=str) == 'MICROMASTER'
'''
FRAMES = [
    r'-+ axisd: frames of /.*/bus -+',
    r'  0\.000000        705  00                       boot-up of node 5',
    r' +\d+\.\d{6} >      605  40 00 10 00 00 00 00 00  SDO to node 5: read 1000:00',
    r' +\d+\.\d{6}        585  43 00 10 00 92 01 FF FF  SDO from node 5: value 1000:00',
    r' +\d+\.\d{6} >      605  40 08 10 00 00 00 00 00  SDO to node 5: read 1008:00',
    r' +\d+\.\d{6}        585  41 08 10 00 08 00 00 00  SDO from node 5: value 1008:00',
    r' +\d+\.\d{6} >      605  60 00 00 00 00 00 00 00  SDO to node 5: upload segment',
    r' +\d+\.\d{6}        585  00 53 49 4E 41 4D 49 43  SDO from node 5: segment',
    r' +\d+\.\d{6} >      605  70 00 00 00 00 00 00 00  SDO to node 5: upload segment',
    r' +\d+\.\d{6}        585  1D 53 00 00 00 00 00 00  SDO from node 5: segment']
UNIT = [
    r'-+ axisd: unit 5 -+',
    r'NMT state Pre-operational, controller error-active, received 4, sent 5',
    r'axis 1 X: Switch on disabled, controlword 0x0000, statusword 0x1640, 0 rpm',
    r'  The node is Pre-operational, so that no PDO is received: send the NMT command start \(01h\).',
    r'  OFF2 is given by .*',
    r'log: axisd: ready: node 5 on unix:/.*/bus']


def consecutive(result, patterns):
    result.stdout.re_match_lines(patterns, consecutive=True)


def test_a_failure_shows_frames_and_unit(pytester):
    pytester.makepyfile(FAILS)
    result = pytester.runpytest_subprocess(*BESIDE)
    result.assert_outcomes(failed=1)
    consecutive(result, FRAMES)
    consecutive(result, UNIT)
    result.stdout.no_fnmatch_line('*conditions.py*')


def test_shows_as_many_frames_as_asked(pytester):
    pytester.makepyfile(FAILS)
    result = pytester.runpytest_subprocess(*BESIDE, '--axisd-frames', '2')
    consecutive(result, [FRAMES[0], 'the last 2 of 9:', *FRAMES[-2:]])
    result = pytester.runpytest_subprocess(*BESIDE, '--axisd-frames', 'many')
    assert result.ret == 4
    result.stderr.fnmatch_lines(["*--axisd-frames: invalid * value: 'many'"])


def test_shows_the_units_of_a_test_without_fixtures(pytester):
    pytester.makepyfile('''
        import axisd

        def test_two():
            with axisd.Unit(node_id=7) as first, axisd.Unit(node_id=8, bus=first):
                first.wait(frame=0x708)
                first.nmt('fly')
    ''')
    result = pytester.runpytest_subprocess(*BESIDE)
    result.assert_outcomes(failed=1)
    result.stdout.re_match_lines_random([
        r'-+ axisd: unit 7 -+', r'-+ axisd: unit 8 -+', r' .* 707  00 +boot-up of node 7',
        r'E +ValueError: command: expected one of start, stop, .*; got "fly"'])


def test_what_passes_shows_nothing(pytester):
    pytester.makepyfile('''
        def test_there(drive, drive_unit, can_bus):
            assert drive is drive_unit and drive.bus is can_bus
    ''')
    result = pytester.runpytest_subprocess(*BESIDE)
    result.assert_outcomes(passed=1)
    result.stdout.no_fnmatch_line('*frames of*')


def test_the_marker_is_checked(pytester):
    pytester.makepyfile('''
        import pytest

        pytestmark = pytest.mark.axisd(axes=2)

        def test_of_the_module(drive):
            assert len(drive.status['axes']) == 2

        @pytest.mark.axisd(axes=3, bit_rate=500_000)
        def test_of_the_test(drive):
            assert len(drive.status['axes']) == 3 and drive.bus.bit_rate == 500_000

        @pytest.mark.axisd(axles=3)
        def test_unknown(drive): pass

        @pytest.mark.axisd(3)
        def test_without_key(drive): pass

        @pytest.mark.axisd(config={'node': 3})
        def test_configuration(drive): pass
    ''')
    result = pytester.runpytest_subprocess(*BESIDE, '--strict-markers')
    result.assert_outcomes(passed=2, errors=3)
    result.stdout.re_match_lines_random([
        r'pytest.mark.axisd: expected keys, some of axes, .*; got axles', r'pytest.mark.axisd: expected keys, .*; got 3',
        r'the drive unit has not started: configuration: /node: unknown key.*'])


def test_twenty_side_by_side(pytester):
    """Each on a bus of its own: with one of all, each would see the boot-up of others."""
    pytester.makepyfile('''
        import pytest

        @pytest.mark.parametrize('number', range(20))
        def test_alone(drive, number):
            drive.write('p1120', number)
            drive.nmt('start')
            drive.wait(nmt='operational')
            drive.switch_on()
            assert drive.read('p1120') == number
            assert [frame.id for frame in drive.bus.frames].count(0x705) == 1
    ''')
    result = pytester.runpytest_subprocess(*BESIDE, '-n', '4')
    result.assert_outcomes(passed=20)


def test_a_failure_of_a_worker_shows_the_same(pytester):
    pytester.makepyfile(FAILS)
    result = pytester.runpytest_subprocess(*BESIDE, '-n', '2')
    result.assert_outcomes(failed=1)
    consecutive(result, FRAMES)
    consecutive(result, UNIT)


def programs_with_page(folder):
    """A folder of programs that is an installation with a page to fill in."""
    bin_folder, web = folder / 'bin', folder / 'share' / 'axisd' / 'web'
    bin_folder.mkdir()
    web.mkdir(parents=True)
    source = pathlib.Path(os.environ['AXISD_BIN_DIR'])
    for name in ('axisd', 'canhub', 'axisctl'):
        shutil.copy(source / name, bin_folder)
    (web / 'session.html').write_text('<script type="application/json" id="session">null</script>', encoding='ascii')
    return str(bin_folder)


def test_a_failure_leaves_a_page(pytester, monkeypatch):
    monkeypatch.setenv('AXISD_BIN_DIR', programs_with_page(pytester.path))
    pytester.makepyfile(FAILS + '''
    import axisd

    def test_passes(drive):
        drive.call('record.status')
        try:
            with axisd.Unit(node_id=7):
                raise ValueError
        except ValueError:
            pass

    def test_closes():
        with axisd.Unit(axes=5, node_id=9):
            assert False
    ''')
    result = pytester.runpytest_subprocess(*BESIDE, '--axisd-html', 'new/pages')
    result.assert_outcomes(failed=2, passed=1)
    pages = pytester.path / 'new' / 'pages'
    name = 'test_a_failure_leaves_a_page.py-test_'
    assert sorted(path.name for path in pages.iterdir()) == [f'{name}closes-9.html', f'{name}reads-5.html']
    result.stdout.re_match_lines_random([f'page: {pages}/{name}reads-5.html', f'page: {pages}/{name}closes-9.html'])
    session = json.loads(re.search('>(.*)<', (pages / f'{name}closes-9.html').read_text(encoding='utf-8')).group(1))
    assert session['title'] == 'test_a_failure_leaves_a_page.py::test_closes'
    assert session['units'][0]['recordings'][0]['name'] == 'run.axrec' and session['units'][0]['resources']['']['node_id'] == 9


def test_without_a_page_to_fill_in_the_report_says_so(pytester, monkeypatch):
    folder = programs_with_page(pytester.path)
    shutil.rmtree(pytester.path / 'share')
    monkeypatch.setenv('AXISD_BIN_DIR', folder)
    pytester.makepyfile(FAILS)
    result = pytester.runpytest_subprocess(*BESIDE, '--axisd-html', 'pages')
    result.assert_outcomes(failed=1)
    result.stdout.re_match_lines_random([r'no page: axisctl: .*/session.html: cannot be read: .*', UNIT[1]])
