using Farseer.Engine.Joints.Kinds;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Joints;

/// <summary>The registry: one line a kind, in the order of <see cref="JointKind"/>.</summary>
[NotState(Why.Fixed)]
internal sealed class JointKinds
{
    private readonly JointForm[] _forms =
    {
        new RevoluteForm(),
        new AngleForm(),
        new AngleLimitForm(),
        new PinForm(),
        new SliderForm(),
        new GearForm(),
        new PrismaticForm(),
        new PulleyForm(),
        new DistanceForm(),
        new WeldForm(),
        new WheelForm(),
        new TargetForm(),
        new RopeForm(),
        new MotorForm(),
        new TransmissionForm(),
    };

    public JointForm Of(JointKind kind) => _forms[(int)kind];
}
