namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>A capsule, from the middle of one end along its axis to that of the other, and the way that it goes.</summary>
internal struct CapsuleWay
{
    public double X;
    public double Y;
    public double AxisX;
    public double AxisY;
    public double Radius;
    public double WayX;
    public double WayY;
}
