namespace UnityEngine.InputSystem
{
    /// <summary>Several controls may be bound to one action: the one that is actuated most drives it.</summary>
    static class ConflictResolution
    {
        /// <summary>Whether a change has no effect on the action. It may be replaced by one of the control that drives the action from now on.</summary>
        internal static bool Ignores(ref ActionState.Trigger trigger, ActionState state)
        {
            if (!state.MayConflict)
                return false;
            if (state.Driver == null)
            {
                state.Magnitude = trigger.Magnitude;
                return false;
            }

            var drives = IsSameSource(trigger.Control, state.Driver);
            if (trigger.Magnitude > state.Magnitude)
            {
                if (!drives && state.Magnitude > 0f)
                    state.HasSeveralActuations = true;
                state.Magnitude = trigger.Magnitude;
                return false;
            }

            if (trigger.Magnitude < state.Magnitude)
            {
                if (!drives)
                {
                    state.HasSeveralActuations |= trigger.Magnitude > 0f;
                    return true;
                }

                if (state.HasSeveralActuations)
                    HandOver(ref trigger, state);
                else
                    state.Magnitude = trigger.Magnitude;
                return false;
            }

            if (drives || !Mathf.Approximately(trigger.Magnitude, state.Magnitude))
                return false;
            state.HasSeveralActuations |= trigger.Magnitude > 0f;
            return true;
        }

        /// <summary>The control that drives the action was eased: another one may be actuated more by now.</summary>
        static void HandOver(ref ActionState.Trigger trigger, ActionState state)
        {
            BoundControl most = null;
            var highest = trigger.Magnitude;
            var actuations = 0;
            foreach (var binding in state.Bindings)
                if (binding.IsComposite)
                    foreach (var control in binding.DrivingControls)
                    {
                        Consider(control, binding.CompositeMagnitude, ref most, ref highest, ref actuations);
                        break; // a composite has one magnitude
                    }
                else
                    foreach (var control in binding.Controls)
                        Consider(control, control.Magnitude, ref most, ref highest, ref actuations);

            if (actuations <= 1)
                state.HasSeveralActuations = false;
            if (most == null)
                return;
            trigger.Control = most;
            trigger.Magnitude = highest;
            state.Driver = most;
            state.Magnitude = highest;
        }

        static void Consider(BoundControl control, float magnitude, ref BoundControl most, ref float highest, ref int actuations)
        {
            if (magnitude > 0f)
                actuations++;
            if (!(magnitude > highest))
                return;
            most = control;
            highest = magnitude;
        }

        /// <summary>Parts of one composite are one source, and so is a control that is bound twice.</summary>
        static bool IsSameSource(BoundControl a, BoundControl b) =>
            a.Control == b.Control || (a.Binding.Composite != null && a.Binding.Composite == b.Binding.Composite);
    }
}
