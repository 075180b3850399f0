# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waiting for promised conditions. No test relies on how fast anything happens."""
import time

import rospy
from rosgraph_msgs.msg import Clock

# Seconds on the wall clock, far more than a loaded machine needs. A kept promise ends the wait.
PATIENCE = 300.0


def eventually(condition, seconds=PATIENCE):
    """Returns the first true value of condition(), or its last value when the time is over."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value or time.monotonic() > end:
            return value
        time.sleep(0.05)


def service(name, service_type):
    """Returns a proxy for a service, once it is there."""
    rospy.wait_for_service(name, PATIENCE)
    return rospy.ServiceProxy(name, service_type)


def reaches(publisher, node):
    """Returns whether a publisher is connected to a node, by its name in the graph. The connections
    of a node that was killed are counted until something is written to them."""
    return '/' + node in [connection.endpoint_id for connection in publisher.impl.connections]


class Latest:
    """The messages of a topic in the order of their arrival."""

    def __init__(self, topic, message_type):
        self.messages = []
        self._subscriber = rospy.Subscriber(topic, message_type, self.messages.append,
                                            queue_size=10000, buff_size=1 << 24)

    def publishers(self):
        """Returns how many publishers are connected."""
        return self._subscriber.get_num_connections()

    def newest(self):
        """Returns the newest message, or None before the first."""
        return self.messages[-1] if self.messages else None

    def wait(self):
        """Returns the newest message, once there is one."""
        assert eventually(lambda: self.messages), self._subscriber.name + ' is silent'
        return self.messages[-1]


def close_and_get_path(close, paths):
    """Returns the answer of slam/close and the path that it published, or None if it refused.
    The path has as many poses as the answer says: one that was published before may come later."""
    before = len(paths.messages)
    answer = close()
    if not answer.success:
        return answer, None
    poses = int(answer.message.split()[0])
    path = eventually(lambda: next((p for p in paths.messages[before:] if len(p.poses) == poses),
                                   None))
    assert path, 'no path of %d poses' % poses
    return answer, path


class SimulatedClock:
    """A /clock that stands still between two settings."""

    def __init__(self):
        self._publisher = rospy.Publisher('/clock', Clock, queue_size=10)

    def set(self, stamp, *get_model):
        """Sets the time, and waits until the modelers behind the services have noticed."""
        assert eventually(lambda: all(self._shown_by(proxy, stamp) for proxy in get_model))

    def _shown_by(self, get_model, stamp):
        self._publisher.publish(Clock(stamp))
        return get_model(which=0, as_built=False, cells=False).planes.header.stamp == stamp
