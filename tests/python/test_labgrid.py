"""A unit as a resource of labgrid: from an environment file, switched off and on, asked, and what is said when it is not there."""

import pytest

labgrid = pytest.importorskip('labgrid', reason='python3-labgrid')

ENVIRONMENT = """
targets:
  main:
    resources:
      AxisdUnit: {{unit: '{unit}', options: ['--socket', '{socket}']}}
    drivers:
      AxisdUnitDriver: {{delay: 0.1}}
imports: [axisd.labgrid_plugin]
"""


def driver_of(folder, unit, socket):
    file = folder / 'environment.yaml'
    file.write_text(ENVIRONMENT.format(unit=unit, socket=socket))
    return labgrid.Environment(str(file)).get_target('main').get_driver('PowerProtocol')


@pytest.fixture(name='power')
def power_of_a_unit(drive, tmp_path):
    return driver_of(tmp_path, drive.call('units')['units'][0]['unit'], drive.control_path)


def test_is_switched_off_and_on(drive, power):
    assert power.get()
    power.off()
    assert not power.get()
    power.on()
    assert power.get()
    drive.call('parameter.write', axis=1, parameter='p1120', value=2.5)
    power.cycle()
    assert drive.read('p1120', axis=1) == 10.0


def test_is_asked(power):
    assert power.call('status')['node_id'] == 5


def test_says_what_is_wrong(drive, power, tmp_path):
    from labgrid.driver.exception import ExecutionError
    with pytest.raises(ExecutionError, match='p9999'):
        power.call('get', '1/p9999')
    with pytest.raises(ExecutionError, match='elsewhere/5'):
        driver_of(tmp_path, 'elsewhere/5', drive.control_path).on()
    with pytest.raises(ExecutionError, match='no such unit'):
        driver_of(tmp_path, 'elsewhere/5', drive.control_path).get()
