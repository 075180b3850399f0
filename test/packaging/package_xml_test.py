#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""package.xml is valid, and rosdep can resolve its keys wherever the package is built."""
import pathlib
import re
import sys
import tempfile
import unittest

try:
    import yaml
    from catkin_pkg.changelog import get_changelog_from_path
    from catkin_pkg.package import InvalidPackage, parse_package
except ImportError:
    sys.stderr.write('skipped: missing catkin\n')
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
KEYS = yaml.safe_load((HERE / 'rosdep_keys.yaml').read_text())
DEBIAN_DATABASE = pathlib.Path('/usr/share/python3-rosdep2/debian.yaml')
# ROS_DISTRO, and the systems on which it is at home.
PLACES = [('Debian', 'debian', 'bullseye'), ('Debian', 'debian', 'bookworm'),
          ('Debian', 'debian', 'trixie'), ('noetic', 'ubuntu', 'focal'),
          ('one', 'ubuntu', 'jammy'), ('one', 'ubuntu', 'noble'), ('one', 'debian', 'bookworm')]


def keys_of(package, ros_distro):
    """Returns the keys whose condition holds, as rosdep and catkin see them."""
    package.evaluate_conditions({'ROS_DISTRO': ros_distro, 'ROS_VERSION': '1',
                                 'ROS_PYTHON_VERSION': '3'})
    lists = [package.buildtool_depends, package.build_depends, package.build_export_depends,
             package.exec_depends, package.test_depends]
    return {dependency.name for each in lists for dependency in each
            if dependency.evaluated_condition}


def packages_of(key, system, release):
    """Returns the packages of a system key, or None if rosdep has none there."""
    rule = KEYS['system'].get(key, {}).get(system)
    return rule.get(release, rule.get('*')) if isinstance(rule, dict) else rule


def unresolved(package, ros_distro, system, release):
    ros = set(KEYS['ros']['all']) | set(KEYS['ros'].get(ros_distro, []))
    return sorted(key for key in keys_of(package, ros_distro)
                  if key not in ros and not packages_of(key, system, release))


def package_with(old, new):
    """Returns package.xml with a text replaced, for mistakes."""
    text = (PROJECT / 'package.xml').read_text()
    assert old in text, old
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / 'package.xml'
        path.write_text(text.replace(old, new))
        return parse_package(str(path))


class PackageXml(unittest.TestCase):
    def setUp(self):
        self.warnings = []
        self.package = parse_package(str(PROJECT), warnings=self.warnings)

    def test_format(self):
        self.assertEqual(self.warnings, [])
        self.assertEqual(self.package.package_format, 3)
        self.assertTrue(self.package.authors)
        self.assertTrue((PROJECT / self.package.licenses[0].file).is_file())

    def test_keys_resolve_everywhere(self):
        for place in PLACES:
            self.assertEqual(unresolved(self.package, *place), [], place)

    def test_keys_that_do_not_resolve_are_noticed(self):
        focal = ('noetic', 'ubuntu', 'focal')
        for old, new, key in [
                ('<test_depend>xvfb', '<test_depend>parallel', 'parallel'),
                ('<depend>liboctomap-dev', '<depend>octomap', 'octomap'),
                ('<build_depend condition="$ROS_DISTRO != noetic">cli11',
                 '<build_depend>cli11', 'cli11')]:
            self.assertEqual(unresolved(package_with(old, new), *focal), [key])
        without = package_with('condition="$ROS_DISTRO != one">sdformat', '>sdformat')
        self.assertEqual(unresolved(without, 'one', 'ubuntu', 'noble'), ['sdformat'])
        with self.assertRaises(InvalidPackage):
            package_with('<depend>zlib</depend>', '<dependency>zlib</dependency>')

    def test_the_copy_of_the_rules_has_nothing_else(self):
        used = set().union(*(keys_of(self.package, ros_distro) for ros_distro, _, _ in PLACES))
        ros = set().union(*(set(names) for names in KEYS['ros'].values()))
        self.assertEqual(used, set(KEYS['system']) | ros)

    def test_libraries_are_those_that_cmake_asks_for(self):
        """Each package of Debian that CMake names as missing comes with a key."""
        text = ''.join(path.read_text() for path in
                       [PROJECT / 'CMakeLists.txt', PROJECT / 'cmake/ros.cmake'])
        named = set(re.findall(r'[\w:-]+=(lib\S+?-dev|\S+-dev)\b', text))
        named = {name for name in named if not re.search(r'msgs|srvs|ros|tf2|topic|diagnostic', name)}
        rules = [rule.get('debian') for rule in KEYS['system'].values()]
        packages = {name for rule in rules
                    for name in (rule['*'] if isinstance(rule, dict) else rule)}
        self.assertGreater(len(named), 5)
        self.assertLessEqual(named, packages)

    @unittest.skipUnless(DEBIAN_DATABASE.is_file(), 'missing python3-rosdep2')
    def test_packages_of_ros_are_keys_of_debian(self):
        debian = yaml.safe_load(DEBIAN_DATABASE.read_text())
        self.assertLessEqual(set(KEYS['ros']['all']), set(debian))

    def test_packages_of_debian_have_the_same_version(self):
        first = (PROJECT / 'debian/changelog').read_text().splitlines()[0]
        self.assertRegex(first, rf'^ribbon-mapper \({re.escape(self.package.version)}\) ')

    def test_changelog(self):
        """REP 132: it can be read, and its newest release is this version or an earlier one."""
        releases = get_changelog_from_path(str(PROJECT / 'CHANGELOG.rst'), 'ribbon_mapper')
        versions = [version for version, _, _ in releases.foreach_version()]
        self.assertTrue(versions)
        as_numbers = [tuple(map(int, version.split('.'))) for version in versions]
        self.assertEqual(as_numbers, sorted(as_numbers))
        self.assertLessEqual(as_numbers[-1], tuple(map(int, self.package.version.split('.'))))


if __name__ == '__main__':
    unittest.main()
