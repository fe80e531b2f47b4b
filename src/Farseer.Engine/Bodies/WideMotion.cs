namespace Farseer.Engine.Bodies;

/// <summary>Velocities of the bodies of a bundle, one per lane.</summary>
internal struct WideVelocity
{
    public Wide X;
    public Wide Y;
    public Wide W;
}

/// <summary>Displacement and turn since the start of the step.</summary>
internal struct WideDelta
{
    public Wide X;
    public Wide Y;
    public Wide Sin;
    public Wide Cos;
}
