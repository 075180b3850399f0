# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""A /clock that stands still between two settings."""
import rospy
from rosgraph_msgs.msg import Clock

from waiting import eventually


class SimulatedClock:
    def __init__(self):
        self._publisher = rospy.Publisher('/clock', Clock, queue_size=10)

    def set(self, stamp, *get_model):
        """Sets the time, and waits until the modelers behind the services have noticed."""
        assert eventually(lambda: all(self._shown_by(proxy, stamp) for proxy in get_model))

    def _shown_by(self, get_model, stamp):
        self._publisher.publish(Clock(stamp))
        return get_model(which=0, as_built=False, cells=False).planes.header.stamp == stamp
