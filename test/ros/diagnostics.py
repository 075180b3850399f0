# SPDX-FileCopyrightText: 2026 ribbon_mapper authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a modeler reports on /diagnostics, once a second."""
from diagnostic_msgs.msg import DiagnosticArray

from waiting import Latest, eventually


class Diagnostics:
    def __init__(self, node='modeler'):
        self._node = node
        self._arrays = Latest('/diagnostics', DiagnosticArray)

    def reports(self):
        """Returns the values by their keys, for each report of the node."""
        return [{value.key: value.value for status in statuses for value in status.values}
                for statuses in ([status for status in array.status
                                  if status.name.startswith(self._node + ':')]
                                 for array in list(self._arrays.messages)) if statuses]

    def value(self, key):
        """Returns the newest value, or None."""
        reports = self.reports()
        return reports[-1].get(key) if reports else None

    def status(self, name):
        """Returns the newest status of a name, or None."""
        wanted = self._node + ': ' + name
        return next((status for array in reversed(list(self._arrays.messages))
                     for status in array.status if status.name == wanted), None)

    def wait_until_handled(self, lines):
        """Waits until the modeler has received so many lines and none of them waits for tf."""
        wanted = (str(lines), '0')
        assert eventually(lambda: (self.value('lines in'),
                                   self.value('lines waiting for tf')) == wanted), self.reports()
