# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waiting for something to become true, by the clock on the wall."""
import time

import rospy


def eventually(condition, seconds=20.0):
    """The first true value of condition(), or its last value when the time is over."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value or time.monotonic() > end:
            return value
        time.sleep(0.05)


class Latest:
    """The messages of a topic as they came in."""

    def __init__(self, topic, message_type):
        self.messages = []
        self._subscriber = rospy.Subscriber(topic, message_type, self.messages.append,
                                            queue_size=10000, buff_size=1 << 24)

    def wait(self, seconds=20.0):
        assert eventually(lambda: self.messages, seconds), self._subscriber.name + ' is silent'
        return self.messages[-1]
