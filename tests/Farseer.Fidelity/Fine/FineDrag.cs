using System;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>
/// A mouse joint with the quirks of the original: force -(k x + c v) at the anchor with k and c those of the frequency and the body's
/// mass, divided by the time step, at most maxForce long; and the body's spin loses 2 % at the beginning of each step.
/// </summary>
internal sealed class FineDrag : IFinePull
{
    private const double DefaultFrequency = 5;
    private const double DefaultDamping = 0.7;
    private const double SpinKept = 0.98;

    private readonly FineBody _body;
    private readonly (double X, double Y) _local;
    private readonly double _stiffness;
    private readonly double _damping;
    private readonly double _most;
    private double _x;
    private double _y;

    public FineDrag(FineBody body, JsonElement joint)
    {
        Id = Json.Text(joint, "id");
        _body = body;
        SetTarget(Json.Required(joint, "target"));
        _local = body.ToLocal((_x, _y));
        double turn = 2 * Math.PI * Json.Number(joint, "frequencyHz", DefaultFrequency);
        double step = Json.Required(joint, "timeStep").GetDouble();
        double mass = 1 / body.InverseMass;
        _stiffness = mass * turn * turn / step;
        _damping = 2 * mass * Json.Number(joint, "dampingRatio", DefaultDamping) * turn / step;
        _most = Json.Required(joint, "maxForce").GetDouble();
    }

    public string Id { get; }

    public void SetTarget(JsonElement target) => (_x, _y) = (target[0].GetDouble(), target[1].GetDouble());

    public void BeginStep() => _body.Spin *= SpinKept;

    public void Pull(double step)
    {
        (double px, double py) = _body.ToWorld(_local);
        (double vx, double vy) = _body.VelocityAt(px, py);
        double fx = -(_stiffness * (px - _x)) - (_damping * vx);
        double fy = -(_stiffness * (py - _y)) - (_damping * vy);
        double length = Math.Sqrt((fx * fx) + (fy * fy));
        double share = length > _most ? _most / length : 1;
        _body.Push(px, py, step * share * fx, step * share * fy);
    }
}
