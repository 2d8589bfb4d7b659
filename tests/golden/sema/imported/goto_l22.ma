behavior_name=goto_list
<start:b_arg>
    b_arg: initial_wpt(enum) 1.0
<end:b_arg>
<start:waypoints>
-7349.8 3910.5
-7346.8 3910.5
<end:waypoints>
