#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every launch file, URDF and rviz file can be read, and every file that it names exists."""
import glob
import os
import re
import unittest
import xml.etree.ElementTree

import roslaunch.arg_dump
import roslaunch.config
import roslaunch.xmlloader
import roslib.packages
import yaml

# Arguments without a default: a mistyped one must not play another recording.
REQUIRED = {'pr2_replay.launch': ['bag:=a.bag']}
PACKAGE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def shipped(pattern):
    files = sorted(glob.glob(os.path.join(PACKAGE, pattern)))
    assert files, pattern
    return files


def required_by(launch_file):
    return REQUIRED.get(os.path.basename(launch_file), [])


def loaded(launch_file, arguments=()):
    """Returns a launch file's configuration. What it requires is given unless `arguments` have it."""
    config = roslaunch.config.ROSLaunchConfig()
    arguments = required_by(launch_file) + list(arguments)
    roslaunch.xmlloader.XmlLoader().load(launch_file, config, argv=arguments, verbose=False)
    return config


class Files(unittest.TestCase):
    def test_launch_files(self):
        for file in shipped('launch/*.launch'):
            config = loaded(file)
            self.assertTrue(config.nodes, file)
            self.assertFalse(config.config_errors, file)
            for node in config.nodes:
                self.assertTrue(node.name and node.package and node.type, file)

    def test_each_launch_file_is_found_once(self):
        for file in shipped('launch/*.launch'):
            name = os.path.basename(file)
            self.assertEqual(roslib.packages.find_resource('ribbon_mapper', name), [file])

    def test_loop_closure_starts_all_of_the_chain(self):
        file = os.path.join(PACKAGE, 'launch/loop_closure.launch')
        names = {node.name for node in loaded(file).nodes}
        self.assertEqual(names, {'pr2_simulator', 'robot_state_publisher', 'modeler', 'correction',
                                 'report'})
        with_slam = loaded(file, ['correction:=slam'])
        self.assertEqual({node.name for node in with_slam.nodes}, names | {'slam'})
        with self.assertRaises(Exception):
            loaded(file, ['correction:=magic'])
        with_rviz = loaded(file, ['rviz:=true'])
        self.assertIn('rviz', {node.name for node in with_rviz.nodes})

    def test_arguments_are_optional_and_documented_as_roslaunch_lists_them(self):
        for file in shipped('launch/*.launch'):
            arguments = roslaunch.arg_dump.get_args([file])
            self.assertTrue(arguments, file)
            required = [argument.split(':=')[0] for argument in required_by(file)]
            for name, (doc, default) in arguments.items():
                self.assertTrue(doc, f'{file}: {name} is undocumented')
                self.assertEqual(default is None, name in required, f'{file}: {name}')

    def test_each_launch_of_a_world_takes_its_models_folders(self):
        for file in shipped('launch/*.launch'):
            if 'world' not in roslaunch.arg_dump.get_args([file]):
                continue
            parameters = loaded(file, ['model_path:=/a:/b', 'simulate:=true']).params
            paths = {name: parameter.value for name, parameter in parameters.items()
                     if name.endswith('/model_path')}
            self.assertIn('/pr2_simulator/model_path', paths, file)
            self.assertEqual(set(paths.values()), {'/a:/b'}, file)

    def test_the_route_is_that_beside_the_world(self):
        for file in shipped('launch/*.launch'):
            if 'route' not in roslaunch.arg_dump.get_args([file]):
                continue
            for world in ('worlds/room.sdf', '/a.b/office.world'):
                given = loaded(file, ['world:=' + world, 'simulate:=true']).params
                route = given['/pr2_simulator/route'].value
                self.assertIn(route, (world.rsplit('.', 1)[0] + end for end in
                                      ('.route.yaml', '_calibration.route.yaml')), file)

    def test_launch_files_hand_their_arguments_on(self):
        for file in shipped('launch/*.launch'):
            arguments = roslaunch.arg_dump.get_args([file])
            if 'mesh_formats' in arguments:
                given = loaded(file, ['mesh_formats:=glb', 'map_period:=3']).params
                self.assertEqual(given['/modeler/mesh_formats'].value, 'glb', file)
                self.assertEqual(given['/modeler/map_period'].value, 3.0, file)

    def test_a_replay_filters_tf_once(self):
        file = os.path.join(PACKAGE, 'launch/pr2_replay.launch')
        given = loaded(file, ['bag:=a.bag', 'slam:=true', 'tf:=/r/tf', 'tf_drop_frames:=map']).params
        self.assertEqual(given['/tf_filter/drop_frames'].value, 'map')
        self.assertEqual(given['/modeler/tf_drop_frames'].value, '', "slam's own map -> odom counts")
        self.assertEqual(given['/slam/tf_drop_frames'].value, '')

    def test_a_replay_with_slam_leaves_out_the_recorded_localisation(self):
        file = os.path.join(PACKAGE, 'launch/pr2_replay.launch')
        dropped = {slam: loaded(file, ['bag:=a.bag', f'slam:={slam}', 'map_frame:=world']).params
                   ['/tf_filter/drop_frames'].value for slam in ('true', 'false')}
        self.assertEqual(dropped, {'true': 'world', 'false': ''})

    def test_bags_may_be_relative_to_the_folder_of_the_command(self):
        file = os.path.join(PACKAGE, 'launch/pr2_replay.launch')
        player = next(node for node in loaded(file, ['bag:=a.bag /b/c.bag d.bag']).nodes
                      if node.name == 'player')
        here = os.environ['PWD']
        self.assertEqual(player.args.split()[-3:], [f'{here}/a.bag', '/b/c.bag', f'{here}/d.bag'])

    def test_files_that_launch_files_name_exist(self):
        for file in shipped('launch/*.launch'):
            with open(file) as text:
                for path in re.findall(r'\$\(find ribbon_mapper\)/([\w./]+)', text.read()):
                    self.assertTrue(os.path.exists(os.path.join(PACKAGE, path)), (file, path))

    def test_urdf(self):
        for file in shipped('urdf/*.urdf'):
            robot = xml.etree.ElementTree.parse(file).getroot()
            links = {link.get('name') for link in robot.findall('link')}
            joints = robot.findall('joint')
            children = [joint.find('child').get('link') for joint in joints]
            self.assertEqual(len(children), len(set(children)), 'a link has two parents')
            self.assertEqual(links - set(children), {'base_footprint'}, 'one tree, one root')
            self.assertTrue({joint.find('parent').get('link') for joint in joints} <= links)

    def test_rviz(self):
        for file in shipped('rviz/*.rviz'):
            with open(file) as text:
                manager = yaml.safe_load(text)['Visualization Manager']
            self.assertEqual(manager['Global Options']['Fixed Frame'], 'map')
            displays = manager['Displays']
            displays += [inner for display in displays for inner in display.get('Displays', [])]
            for display in displays:
                self.assertTrue(display['Class'].startswith('rviz/'), display)
                self.assertIn('Name', display)


if __name__ == '__main__':
    unittest.main()
