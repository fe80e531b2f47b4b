using System.Collections.Generic;
using Farseer.Engine.Joints;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.Flash;

/// <summary>The numbers that a joint is made of, by their names in files.</summary>
internal static class JointValues
{
    private delegate ref double Value(ref JointSettings settings);

    private static readonly KeyValuePair<string, Value>[] s_all =
    [
        Of("anchor1X", static (ref JointSettings s) => ref s.AnchorAX),
        Of("anchor1Y", static (ref JointSettings s) => ref s.AnchorAY),
        Of("anchor2X", static (ref JointSettings s) => ref s.AnchorBX),
        Of("anchor2Y", static (ref JointSettings s) => ref s.AnchorBY),
        Of("ground1X", static (ref JointSettings s) => ref s.GroundAX),
        Of("ground1Y", static (ref JointSettings s) => ref s.GroundAY),
        Of("ground2X", static (ref JointSettings s) => ref s.GroundBX),
        Of("ground2Y", static (ref JointSettings s) => ref s.GroundBY),
        Of("axisX", static (ref JointSettings s) => ref s.AxisX),
        Of("axisY", static (ref JointSettings s) => ref s.AxisY),
        Of("target", static (ref JointSettings s) => ref s.Target),
        Of("lower", static (ref JointSettings s) => ref s.Lower),
        Of("upper", static (ref JointSettings s) => ref s.Upper),
        Of("ratio", static (ref JointSettings s) => ref s.Ratio),
        Of("motorSpeed", static (ref JointSettings s) => ref s.MotorSpeed),
        Of("motorLimit", static (ref JointSettings s) => ref s.MotorLimit),
        Of("frequency", static (ref JointSettings s) => ref s.Frequency),
        Of("dampingRatio", static (ref JointSettings s) => ref s.DampingRatio),
    ];

    public static void Write(JointSettings settings, SceneSink sink)
    {
        foreach (KeyValuePair<string, Value> value in s_all)
        {
            sink.Number(value.Key, value.Value(ref settings));
        }
    }

    public static void Read(ref JointSettings settings, SceneObject members)
    {
        foreach (KeyValuePair<string, Value> value in s_all)
        {
            if (members.TryTake(value.Key, out SceneNode node))
            {
                value.Value(ref settings) = node.Finite();
            }
        }
    }

    private static KeyValuePair<string, Value> Of(string name, Value value) => new KeyValuePair<string, Value>(name, value);
}
