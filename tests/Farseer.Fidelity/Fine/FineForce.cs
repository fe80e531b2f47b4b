namespace Farseer.Fidelity.Fine;

/// <summary>What a program applies to a body for one step: it is the same throughout the step.</summary>
internal sealed class FineForce(FineBody body) : IFinePull
{
    private double _x;
    private double _y;
    private double _torque;

    public void Clear() => (_x, _y, _torque) = (0, 0, 0);

    public void Add(double x, double y, double torque) => (_x, _y, _torque) = (_x + x, _y + y, _torque + torque);

    public void BeginStep()
    {
    }

    public void Pull(double step)
    {
        body.VelocityX += step * body.InverseMass * _x;
        body.VelocityY += step * body.InverseMass * _y;
        body.Spin += step * body.InverseInertia * _torque;
    }
}
