#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""The build, installed below a folder of its own, works from any folder and offers what it should.

Usage: installed_test.py BUILD SOURCE CXX PROGRAM...
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
BUILD, SOURCE = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
CXX, PROGRAMS = sys.argv[3], set(sys.argv[4:])
WITH_SIMULATOR = 'experiment' in PROGRAMS
COMPLETIONS = [pathlib.Path(path) for path in [
    '/usr/share/bash-completion/completions/rosbash', '/usr/share/rosbash/rosbash',
    '/opt/ros/noetic/share/rosbash/rosbash'] if os.path.isfile(path)]
LAUNCH_FILES_OF_SIM = set() if WITH_SIMULATOR else {'simulate.launch', 'loop_closure.launch'}
NO_MASTER = 'http://localhost:1'  # where no ROS master can be


def run(*command, **options):
    """Runs a command and returns what it printed; an AssertionError has that if it fails."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            **options)
    assert result.returncode == 0, f'{command} failed:\n{result.stdout}'
    return result.stdout


def install(prefix):
    run('cmake', '--install', str(BUILD), '--prefix', str(prefix))


def environment(prefix, home):
    """What a shell has that knows the prefix only: PATH, its setup.bash, and no ROS master."""
    bare = {'HOME': str(home), 'PATH': '/usr/bin:/bin', 'LANG': 'C.UTF-8'}
    text = run('bash', '-c', f'source {prefix}/setup.bash && env -0', env=bare)
    result = dict(line.split('=', 1) for line in text.split('\0') if line)
    return {**result, 'ROS_MASTER_URI': NO_MASTER, 'ROS_HOSTNAME': 'localhost'}


def is_elf(path):
    with open(path, 'rb') as file:
        return file.read(4) == b'\x7fELF'


def is_program(path):
    return is_elf(path) and os.access(path, os.X_OK)


def faults_of_libraries(path, env):
    """Returns the lines of ldd that say that a library is missing or comes from the build.

    LD_LIBRARY_PATH, which setup.bash sets, is left out: it would hide a wrong RPATH.
    """
    lines = run('ldd', str(path), env={**env, 'LD_LIBRARY_PATH': ''}).splitlines()
    return [line for line in lines if 'not found' in line or str(BUILD) in line]


def missing_files(launch_file, share):
    """Returns the files of $(find ribbon_mapper) in a launch file that are not in `share`."""
    names = re.findall(r'\$\(find ribbon_mapper\)/((?:\$\(arg \w+\)|[^"\s])+)',
                       launch_file.read_text())
    patterns = {name: re.sub(r'\$\(arg \w+\)', '*', name) for name in names}
    return [name for name, pattern in patterns.items() if not list(share.glob(pattern))]


def offered_by_rosrun(env):
    """Returns what bash completes after `rosrun ribbon_mapper `."""
    script = (f'source {COMPLETIONS[0]}; '
              'COMP_WORDS=(rosrun ribbon_mapper ""); COMP_CWORD=2; '
              '_roscomplete_exe; printf "%s\\n" "${COMPREPLY[@]}"')
    return set(run('bash', '-c', script, env=env).split())


def starts(program, env, folder):
    """Returns whether a program, or a node, says what it is."""
    said = subprocess.run([str(program), '--help'], env=env, cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    return said.returncode == 0 and ('Usage:' in said.stdout or 'a node of ROS' in said.stdout)


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix='installed_')
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        cls.prefix = cls.scratch / 'prefix'
        cls.elsewhere = cls.scratch / 'elsewhere'
        cls.elsewhere.mkdir()
        install(cls.prefix)
        cls.env = environment(cls.prefix, cls.scratch)
        cls.bin = cls.prefix / 'lib/ribbon_mapper'
        cls.share = cls.prefix / 'share/ribbon_mapper'

    def run_elsewhere(self, *command):
        return run(*map(str, command), env=self.env, cwd=self.elsewhere)

    def test_programs_lie_where_rosrun_finds_them_and_nothing_else(self):
        self.assertEqual({path.name for path in self.bin.iterdir()}, PROGRAMS)
        self.assertTrue(all(is_program(path) for path in self.bin.iterdir()))

    @unittest.skipUnless(COMPLETIONS, 'missing rosbash')
    def test_rosrun_offers_programs_only(self):
        self.assertEqual(offered_by_rosrun(self.env), PROGRAMS)
        script = self.share / 'eval/figures/before_after.py'
        script.chmod(0o755)
        self.addCleanup(script.chmod, 0o644)
        self.assertEqual(offered_by_rosrun(self.env), PROGRAMS | {script.name})  # can fail

    def test_programs_start(self):
        for program in sorted(PROGRAMS):
            self.assertTrue(starts(self.bin / program, self.env, self.elsewhere), program)

    def test_libraries_are_found_in_the_prefix(self):
        objects = [path for path in (self.prefix / 'lib').rglob('*')
                   if path.is_file() and is_elf(path)]
        self.assertGreater(len(objects), len(PROGRAMS))
        for path in objects:
            self.assertEqual(faults_of_libraries(path, self.env), [], path)

    def test_a_program_without_its_library_is_noticed(self):
        moved = self.elsewhere / 'modeler'
        shutil.copy(self.bin / 'modeler', moved)
        self.assertIn('libribbon_mapper_core', ''.join(faults_of_libraries(moved, self.env)))
        env = {**self.env, 'LD_LIBRARY_PATH': ''}
        self.assertFalse(starts(moved, env, self.elsewhere))

    def test_no_file_names_the_source_or_the_build(self):
        files = [path for path in self.prefix.rglob('*') if path.is_file() and not is_elf(path)]
        for path in files:
            if path.suffix not in ['.a', '.pyc']:
                text = path.read_text(errors='replace')
                self.assertFalse(str(BUILD) in text or str(SOURCE) in text, path)

    def test_files_that_launch_files_name_are_there(self):
        launch_files = sorted((self.share / 'launch').glob('*.launch'))
        self.assertEqual({path.name for path in launch_files},
                         {path.name for path in (SOURCE / 'launch').glob('*.launch')} -
                         LAUNCH_FILES_OF_SIM)
        for path in launch_files:
            missing = {pathlib.Path(name).name for name in missing_files(path, self.share)}
            self.assertLessEqual(missing, LAUNCH_FILES_OF_SIM, path)
            nodes = re.findall(r'pkg="ribbon_mapper" type="(\w+)"', path.read_text())
            if WITH_SIMULATOR:
                self.assertLessEqual(set(nodes), PROGRAMS, path)

    def test_a_launch_file_that_names_a_missing_file_is_noticed(self):
        path = self.elsewhere / 'wrong.launch'
        path.write_text('<include file="$(find ribbon_mapper)/launch/none.launch"/>')
        self.assertEqual(missing_files(path, self.share), ['launch/none.launch'])

    def test_launch_files_load(self):
        needed = {'pr2_replay.launch': ['bag:=a.bag']}
        if not WITH_SIMULATOR:
            needed['calibrate.launch'] = ['simulate:=false']
        for path in sorted((self.share / 'launch').glob('*.launch')):
            nodes = self.run_elsewhere('roslaunch', 'ribbon_mapper', path.name,
                                       *needed.get(path.name, []), '--nodes')
            self.assertIn('/', nodes, path)

    # The files have names that the source folder lacks: it cannot help out.
    def copy_within_prefix(self, name):
        path = self.share / name
        shutil.copy(path, path.with_name('installed_' + path.name))

    def test_presets_and_scripts_are_found_from_any_folder(self):
        self.copy_within_prefix('config/pr2.yaml')
        bag, preset = self.share / 'test/data/small_room.bag', 'config/installed_pr2.yaml'
        report = self.run_elsewhere(self.bin / 'bag_check', bag, '--config', preset)
        self.assertIn('this can be mapped', report)
        self.run_elsewhere(self.bin / 'offline_modeler', '--bag', bag, '--output', 'room',
                           '--config', preset, '--figure')
        self.assertTrue((self.elsewhere / 'room/model_views.png').is_file())

    @unittest.skipUnless(WITH_SIMULATOR, 'the simulator is not built')
    def test_worlds_are_found_from_any_folder(self):
        for name in ['worlds/room.sdf', 'worlds/room.route.yaml']:
            self.copy_within_prefix(name)
        self.run_elsewhere(self.bin / 'record_tour', '--world', 'worlds/installed_room.sdf',
                           '--route', 'worlds/installed_room.route.yaml', '--seconds', '1',
                           '--bag', 'room.bag')
        self.assertTrue((self.elsewhere / 'room.bag').is_file())

    @unittest.skipUnless(WITH_SIMULATOR, 'the simulator is not built')
    def test_each_file_is_in_one_package_of_debian(self):
        lists = [path.read_text().split() for path in (SOURCE / 'debian').glob('*.install')]
        packaged = sorted(name for each in lists for name in each)
        for folder in ['lib', 'share']:
            start = f'usr/{folder}/ribbon_mapper/'
            self.assertEqual([name[len(start):] for name in packaged if name.startswith(start)],
                             sorted(path.name for path in (self.prefix / start[4:]).iterdir()))

    def test_messages_are_there_for_python(self):
        code = 'import ribbon_mapper.msg as m, ribbon_mapper.srv; print(m.__file__, m.PlaneArray())'
        self.assertIn(str(self.prefix), self.run_elsewhere('/usr/bin/python3', '-c', code))

    def test_a_foreign_catkin_package_builds(self):
        build = self.scratch / 'consumer'
        self.run_elsewhere('cmake', '-S', HERE / 'catkin_consumer', '-B', build,
                           f'-DCMAKE_CXX_COMPILER={CXX}', '-DPYTHON_EXECUTABLE=/usr/bin/python3')
        self.run_elsewhere('cmake', '--build', build)
        program = build / 'devel/lib/catkin_consumer/subscriber'
        self.assertEqual(faults_of_libraries(program, self.env), [])
        self.assertIn('planes: 0', self.run_elsewhere(program))


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
