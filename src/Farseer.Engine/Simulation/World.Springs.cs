using Farseer.Engine.Springs;

namespace Farseer.Engine.Simulation;

/// <summary>Springs are handed in by the hooks, in each step anew.</summary>
internal sealed partial class World
{
    /// <summary>Lets a spring act in the step under way; only from <see cref="IStepHooks.ApplyForces"/>.</summary>
    public void ApplySpring(in SpringDef def)
    {
        if (AsleepCount == 0 || WakesBySpring(def.BodyA, def.BodyB))
        {
            _springs.Add(def);
        }
    }
}
