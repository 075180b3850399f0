#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""rviz with the configuration of each launch file: planes and scan are seen, and nothing is wrong.

Usage: rviz_test.py MODELER OFFLINE_MODELER: the programs, whose model of a small room is shown.
"""
import glob
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'test/ros'))

NO_TEST = 77  # ctest then says that it was skipped
NEEDED = ['rviz', 'Xvfb']
SCAN = (255, 84, 64)  # as configured
WRONG = (192, 32, 32)  # of the icon of a display with an error
ICONS = 40  # columns of the picture that have the icons

# The launch files that start rviz: arguments, the namespace of the nodes, and the topic of scans.
CASES = {
    'loop_closure': ([], '/', '/tilt_scan'),
    'modeler': (['scan:=my_scan'], '/robot1', '/robot1/my_scan'),
    'pr2': (['scan:=/front/scan'], '/', '/front/scan'),
    'pr2_replay': (['bag:=a.bag'], '/', '/tilt_scan'),
    'simulate': ([], '/', '/tilt_scan'),
    'slam': (['scan:=other_scan'], '/', '/other_scan'),
}


def rviz_node(launch_file, arguments):
    """Returns the node of rviz that a launch file starts with rviz:=true, or None."""
    import roslaunch.config
    import roslaunch.xmlloader
    config = roslaunch.config.ROSLaunchConfig()
    arguments = ['rviz:=true'] + arguments
    roslaunch.xmlloader.XmlLoader().load(launch_file, config, argv=arguments, verbose=False)
    return next((node for node in config.nodes if node.type == 'rviz'), None)


def launch_file(name):
    return str(ROOT / 'launch' / (name + '.launch'))


class RvizTest(unittest.TestCase):
    """Each case starts rviz on a screen of its own."""

    programs = []  # modeler and offline_modeler

    @classmethod
    def setUpClass(cls):
        from robot import Robot
        cls.folder = tempfile.TemporaryDirectory()
        cls.nodes = []
        modeler, offline_modeler = cls.programs
        subprocess.run([offline_modeler, '--bag', ROOT / 'test/data/small_room.bag', '--output',
                        cls.folder.name], check=True, stdout=subprocess.DEVNULL)
        for namespace in sorted({namespace for _, namespace, _ in CASES.values()}):
            cls.start([modeler, '__name:=modeler', '__ns:=' + namespace,
                       '_config:=' + str(ROOT / 'config/pr2.yaml'),
                       '_output_dir:=' + cls.folder.name,
                       '_load:=' + cls.folder.name + '/model.ribbons'])
        cls.robot = Robot((ROOT / 'urdf/pr2_tilt.urdf').read_text(),
                          sorted({topic for _, _, topic in CASES.values()}))
        cls.start(cls.robot.state_publisher())

    @classmethod
    def start(cls, command):
        cls.nodes.append(subprocess.Popen(command, stdout=subprocess.DEVNULL))

    @classmethod
    def tearDownClass(cls):
        for node in cls.nodes:
            node.terminate()
            node.wait()
        cls.folder.cleanup()

    def setUp(self):
        from screen import Screen
        self.screen = Screen()
        self.output = tempfile.TemporaryFile('w+')
        self.rviz = None

    def tearDown(self):
        if self.rviz:
            self.rviz.terminate()
            self.rviz.wait()
        self.screen.close()

    def start_rviz(self, name):
        arguments, namespace, _ = CASES[name]
        node = rviz_node(launch_file(name), arguments)
        command = ['rviz'] + node.args.split() + ['__ns:=' + namespace, '__name:=rviz_' + name]
        command += [f'{old}:={new}' for old, new in node.remap_args]
        self.rviz = subprocess.Popen(command, stdout=self.output, stderr=subprocess.STDOUT,
                                     env=self.screen.environment)

    def errors(self):
        """Returns the lines in which rviz reports errors, as roscpp marks them."""
        self.output.seek(0)
        return re.findall(r'.*\[ ?(?:ERROR|FATAL)\].*', self.output.read())

    def planes_seen(self, namespace):
        """Returns how many planes are in the picture, each by its colour."""
        from screen import count
        picture = self.screen.picture()
        return sum(count(picture, colour) > 300 for colour in self.robot.colours(namespace))

    def wait(self, condition, what):
        from waiting import eventually
        done = eventually(lambda: condition() or self.rviz.poll() is not None)
        self.assertIsNone(self.rviz.poll(), f'rviz has ended: {self.errors()}')
        self.assertTrue(done, f'never seen: {what}; errors: {self.errors()}; '
                              f'picture: {done or self.screen.save()}')

    def check(self, name):
        from screen import count
        namespace = CASES[name][1]
        self.start_rviz(name)
        if name != 'simulate':
            self.wait(lambda: self.planes_seen(namespace) >= 3, 'three planes')
        self.wait(lambda: count(self.screen.picture(), SCAN) > 20, 'the scan')
        self.wait(lambda: count(self.screen.picture()[:, :ICONS], WRONG) == 0, 'displays without errors')
        self.assertEqual(self.errors(), [])

    def test_no_launch_file_is_forgotten(self):
        starting = {pathlib.Path(file).stem for file in glob.glob(launch_file('*'))
                    if 'name="rviz"' in pathlib.Path(file).read_text() and rviz_node(file, ['bag:=a.bag'])}
        self.assertEqual(starting, set(CASES))


def add_cases():
    for name in CASES:
        setattr(RvizTest, 'test_' + name, lambda self, name=name: self.check(name))


def master():
    """Starts a ROS master on a free port, and leads this process and its children to it."""
    import rosgraph
    from waiting import eventually
    with socket.socket() as free:
        free.bind(('localhost', 0))
        port = free.getsockname()[1]
    os.environ.update(ROS_MASTER_URI=f'http://localhost:{port}', ROS_HOSTNAME='localhost')
    process = subprocess.Popen(['rosmaster', '--core', '-p', str(port)], stdout=subprocess.DEVNULL)
    assert eventually(rosgraph.is_master_online), 'the master does not start'
    return process


def main(programs):
    if shutil.which('rviz') is None:
        print('Skipped: missing rviz (./install_dependencies rviz)')
        return NO_TEST
    missing = [program for program in NEEDED if shutil.which(program) is None]
    if missing:
        print(f'Missing beside rviz: {", ".join(missing)} (./install_dependencies rviz)')
        return 1
    with tempfile.TemporaryDirectory() as home:
        os.environ['ROS_HOME'] = home
        the_master = master()
        try:
            RvizTest.programs = programs
            add_cases()
            result = unittest.main(module=__name__, argv=[sys.argv[0]] + sys.argv[3:], exit=False).result
            return 0 if result.wasSuccessful() else 1
        finally:
            the_master.terminate()
            the_master.wait()


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:3]))
